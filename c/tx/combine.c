/* The colour combiner: (A - B) * C + D in 9 bits, once or twice. */
#include "tx/bits.h"
#include "tx/pixel.h"

enum codes {
    COMBINED, TEXEL0, TEXEL1, PRIMITIVE, SHADE, ENVIRONMENT, ONE, ZERO,
    /* A and B of R G B */
    NOISE = 7, KEY_CENTRE = 6, K4 = 7,
    /* C of R G B */
    KEY_SCALE = 6, COMBINED_ALPHA = 7, TEXEL0_ALPHA, TEXEL1_ALPHA, PRIMITIVE_ALPHA, SHADE_ALPHA,
    ENVIRONMENT_ALPHA, FRACTION, PRIMITIVE_FRACTION, K5,
    /* C of alpha */
    ALPHA_FRACTION = 0, ALPHA_PRIMITIVE_FRACTION = 6
};

/* What a cycle's codes stand for; channel 0-3: R G B A. */
struct inputs {
    int32 colours[6][4];        /* COMBINED to ENVIRONMENT */
    int32 fraction, primitive_fraction, k4, k5;
};

static int32 rgb_a(const struct inputs *in, uint32 code, int32 channel)
{
    return code < ONE ? in->colours[code][channel] : code == ONE ? 0x100 : 0;
}

static int32 rgb_b(const struct inputs *in, uint32 code, int32 channel)
{
    return code < KEY_CENTRE ? in->colours[code][channel] : code == K4 ? in->k4 : 0;
}

static int32 rgb_c(const struct inputs *in, uint32 code, int32 channel)
{
    if (code < KEY_SCALE)
        return in->colours[code][channel];
    if (code >= COMBINED_ALPHA && code <= ENVIRONMENT_ALPHA)
        return in->colours[code - COMBINED_ALPHA][3];
    return code == FRACTION ? in->fraction : code == PRIMITIVE_FRACTION ? in->primitive_fraction
        : code == K5 ? in->k5 : 0;
}

static int32 rgb_d(const struct inputs *in, uint32 code, int32 channel)
{
    return code < ONE ? in->colours[code][channel] : code == ONE ? 0x100 : 0;
}

static int32 alpha_abd(const struct inputs *in, uint32 code)
{
    return rgb_d(in, code, 3);
}

static int32 alpha_c(const struct inputs *in, uint32 code)
{
    return code == ALPHA_FRACTION ? in->fraction
        : code == ALPHA_PRIMITIVE_FRACTION ? in->primitive_fraction
        : code < ONE ? in->colours[code][3] : 0;
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
        made[i] = combine(rgb_a(in, rgb->a, i), rgb_b(in, rgb->b, i), rgb_c(in, rgb->c, i),
                          rgb_d(in, rgb->d, i));
    made[3] = combine(alpha_abd(in, alpha->a), alpha_abd(in, alpha->b), alpha_c(in, alpha->c),
                      alpha_abd(in, alpha->d));
    for (int32 i = 0; i < 4; i++)
        in->colours[COMBINED][i] = made[i];
}

static void put(struct inputs *in, int32 code, const struct tx_colour *colour)
{
    in->colours[code][0] = colour->r;
    in->colours[code][1] = colour->g;
    in->colours[code][2] = colour->b;
    in->colours[code][3] = colour->a;
}

int32 tx_clamp_9(int32 value)
{
    value &= 0x1ff;
    return (value & 0x180) == 0x180 ? 0 : value & 0x100 ? 255 : value;
}

uint32 tx_combine_pixel(const struct tx *tx, const struct tx_sources *sources)
{
    struct inputs in;
    uint32 colour = 0;

    for (int32 i = 0; i < 4; i++) {
        in.colours[COMBINED][i] = 0;
        in.colours[PRIMITIVE][i] = tx->primitive[i];
        in.colours[ENVIRONMENT][i] = tx->environment[i];
    }
    put(&in, SHADE, &sources->shade);
    put(&in, TEXEL0, &sources->texel0);
    put(&in, TEXEL1, &sources->texel1);
    in.fraction = sources->fraction;
    in.primitive_fraction = tx->primitive_fraction;
    in.k4 = tx->k[4];
    in.k5 = tx->k[5];
    if (tx->modes.cycle == TX_TWO_CYCLES) {
        combine_cycle(&tx->combine, 0, &in);
        put(&in, TEXEL0, &sources->texel1);
        put(&in, TEXEL1, &sources->texel0);
    }
    combine_cycle(&tx->combine, 1, &in);
    for (int32 i = 0; i < 4; i++)
        colour = colour << 8 | (uint32)tx_clamp_9(in.colours[COMBINED][i]);
    return colour;
}

enum tx_result tx_check_combine(const struct tx_combine *combine)
{
    for (int32 cycle = 0; cycle < 2; cycle++)
        if (combine->rgb[cycle].a == NOISE || combine->rgb[cycle].b == KEY_CENTRE
            || combine->rgb[cycle].c == KEY_SCALE)
            return TX_COMBINE_INPUT;
    return TX_DONE;
}

/* enum tx_inputs of one of the codes that mean the same in all places. */
static uint32 input_of(uint32 code)
{
    return code == TEXEL0 ? TX_INPUT_TEXEL0 : code == TEXEL1 ? TX_INPUT_TEXEL1
        : code == SHADE ? TX_INPUT_SHADE : 0;
}

static uint32 cycle_inputs(const struct tx_combine *combine, int32 cycle)
{
    const struct tx_input *rgb = &combine->rgb[cycle], *alpha = &combine->alpha[cycle];
    uint32 inputs = input_of(rgb->a) | input_of(rgb->b) | input_of(rgb->c) | input_of(rgb->d)
        | input_of(alpha->a) | input_of(alpha->b) | input_of(alpha->c) | input_of(alpha->d);

    if (rgb->c >= TEXEL0_ALPHA && rgb->c <= SHADE_ALPHA)
        inputs |= input_of(rgb->c - COMBINED_ALPHA);
    if (rgb->c == FRACTION || alpha->c == ALPHA_FRACTION)
        inputs |= TX_INPUT_LOD_FRACTION;
    return inputs;
}

/* In one-cycle mode texel 1 is texel 0; in the second of two cycles they change places. */
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
    tx->inputs = inputs;
}
