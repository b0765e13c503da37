/* The colour combiner: (A - B) * C + D in 9 bits, once or twice. */
#include "tx/bits.h"
#include "tx/codes.h"
#include "tx/pixel.h"

/* What a cycle's codes stand for; channel 0-3: R G B A. */
struct inputs {
    int32 colours[6][4];        /* TX_CODE_COMBINED to TX_CODE_ENVIRONMENT */
    int32 fraction, primitive_fraction, k4, k5;
};

static int32 rgb_ad(const struct inputs *in, uint32 code, int32 channel)
{
    return code < TX_CODE_ONE ? in->colours[code][channel] : code == TX_CODE_ONE ? 0x100 : 0;
}

static int32 rgb_b(const struct inputs *in, uint32 code, int32 channel)
{
    return code < TX_CODE_KEY_CENTRE ? in->colours[code][channel] : code == TX_CODE_K4 ? in->k4 : 0;
}

static int32 rgb_c(const struct inputs *in, uint32 code, int32 channel)
{
    if (code < TX_CODE_KEY_SCALE)
        return in->colours[code][channel];
    if (code >= TX_CODE_COMBINED_ALPHA && code <= TX_CODE_ENVIRONMENT_ALPHA)
        return in->colours[code - TX_CODE_COMBINED_ALPHA][3];
    return code == TX_CODE_FRACTION ? in->fraction
        : code == TX_CODE_PRIMITIVE_FRACTION ? in->primitive_fraction
        : code == TX_CODE_K5 ? in->k5 : 0;
}

static int32 alpha_abd(const struct inputs *in, uint32 code)
{
    return rgb_ad(in, code, 3);
}

static int32 alpha_c(const struct inputs *in, uint32 code)
{
    return code == TX_CODE_ALPHA_FRACTION ? in->fraction
        : code == TX_CODE_ALPHA_PRIMITIVE_FRACTION ? in->primitive_fraction
        : code < TX_CODE_ONE ? in->colours[code][3] : 0;
}

/* A, B and D: a quarter of the range is negative. */
static int32 extend(int32 value)
{
    value &= 0x1ff;
    return (value & 0x180) == 0x180 ? value - 512 : value;
}

static int32 combine(int32 a, int32 b, int32 c, int32 d)
{
    const int32 sum = (extend(a) - extend(b)) * tx_signed_9(c) + extend(d) * 256 + 0x80;

    return sum >> 8 & 0x1ff;
}

static void combine_cycle(const struct tx_combine *codes, int32 cycle, struct inputs *in)
{
    const struct tx_input *rgb = &codes->rgb[cycle], *alpha = &codes->alpha[cycle];
    int32 made[4];

    for (int32 i = 0; i < 3; i++)
        made[i] = combine(rgb_ad(in, rgb->a, i), rgb_b(in, rgb->b, i), rgb_c(in, rgb->c, i),
                          rgb_ad(in, rgb->d, i));
    made[3] = combine(alpha_abd(in, alpha->a), alpha_abd(in, alpha->b), alpha_c(in, alpha->c),
                      alpha_abd(in, alpha->d));
    for (int32 i = 0; i < 4; i++)
        in->colours[TX_CODE_COMBINED][i] = made[i];
}

static void put(struct inputs *in, int32 code, const struct tx_colour *colour)
{
    in->colours[code][0] = colour->r;
    in->colours[code][1] = colour->g;
    in->colours[code][2] = colour->b;
    in->colours[code][3] = colour->a;
}

/* 9 bits to 0-255. */
static int32 clamp_9(int32 value)
{
    value &= 0x1ff;
    return (value & 0x180) == 0x180 ? 0 : value & 0x100 ? 255 : value;
}

uint32 tx_combine_pixel(const struct tx *tx, const struct tx_sources *sources)
{
    struct inputs in;
    uint32 colour = 0;

    for (int32 i = 0; i < 4; i++) {
        in.colours[TX_CODE_COMBINED][i] = 0;
        in.colours[TX_CODE_PRIMITIVE][i] = tx->primitive[i];
        in.colours[TX_CODE_ENVIRONMENT][i] = tx->environment[i];
    }
    put(&in, TX_CODE_SHADE, &sources->shade);
    put(&in, TX_CODE_TEXEL0, &sources->texel0);
    put(&in, TX_CODE_TEXEL1, &sources->texel1);
    in.fraction = sources->fraction;
    in.primitive_fraction = tx->primitive_fraction;
    in.k4 = tx->k[4];
    in.k5 = tx->k[5];
    if (tx->modes.cycle == TX_TWO_CYCLES) {
        combine_cycle(&tx->combine, 0, &in);
        put(&in, TX_CODE_TEXEL0, &sources->texel1);
        put(&in, TX_CODE_TEXEL1, &sources->texel0);
    }
    combine_cycle(&tx->combine, 1, &in);
    for (int32 i = 0; i < 4; i++)
        colour = colour << 8 | (uint32)clamp_9(in.colours[TX_CODE_COMBINED][i]);
    return colour;
}

enum tx_result tx_check_combine(const struct tx_combine *combine)
{
    for (int32 cycle = 0; cycle < 2; cycle++)
        if (combine->rgb[cycle].a == TX_CODE_NOISE || combine->rgb[cycle].b == TX_CODE_KEY_CENTRE
            || combine->rgb[cycle].c == TX_CODE_KEY_SCALE)
            return TX_COMBINE_INPUT;
    return TX_DONE;
}

/* enum tx_inputs of one of the codes that mean the same in all places. */
static uint32 input_of(uint32 code)
{
    return code == TX_CODE_TEXEL0 ? TX_INPUT_TEXEL0 : code == TX_CODE_TEXEL1 ? TX_INPUT_TEXEL1
        : code == TX_CODE_SHADE ? TX_INPUT_SHADE : 0;
}

static uint32 cycle_inputs(const struct tx_combine *combine, int32 cycle)
{
    const struct tx_input *rgb = &combine->rgb[cycle], *alpha = &combine->alpha[cycle];
    uint32 inputs = input_of(rgb->a) | input_of(rgb->b) | input_of(rgb->c) | input_of(rgb->d)
        | input_of(alpha->a) | input_of(alpha->b) | input_of(alpha->c) | input_of(alpha->d);

    if (rgb->c >= TX_CODE_TEXEL0_ALPHA && rgb->c <= TX_CODE_SHADE_ALPHA)
        inputs |= input_of(rgb->c - TX_CODE_COMBINED_ALPHA);
    if (rgb->c == TX_CODE_FRACTION || alpha->c == TX_CODE_ALPHA_FRACTION)
        inputs |= TX_INPUT_LOD_FRACTION;
    return inputs;
}

/* In one-cycle mode texel 1 is texel 0; in the second of two cycles they change places. Copy mode
   knows no combiner. */
void tx_find_inputs(struct tx *tx)
{
    const uint32 both = TX_INPUT_TEXEL0 | TX_INPUT_TEXEL1;
    uint32 inputs = cycle_inputs(&tx->combine, 1);

    if (tx->modes.cycle != TX_TWO_CYCLES) {
        if (inputs & both)
            inputs = (inputs & ~both) | TX_INPUT_TEXEL0;
    } else {
        if ((inputs & both) == TX_INPUT_TEXEL0 || (inputs & both) == TX_INPUT_TEXEL1)
            inputs ^= both;
        inputs |= cycle_inputs(&tx->combine, 0);
    }
    tx->inputs = tx->modes.cycle == TX_COPY ? TX_INPUT_TEXEL0 : inputs;
}
