/* The colour combiner: (A - B) * C + D in 9 bits, once or twice. */
#include "n64/bits.h"
#include "n64/codes.h"
#include "n64/pixel.h"

/* Values of the codes of a cycle; channel 0-3: R G B A. */
struct inputs {
    int32 colours[6][4];        /* N64_CODE_COMBINED to N64_CODE_ENVIRONMENT */
    int32 fraction, primitive_fraction, k4, k5;
};

static int32 rgb_ad(const struct inputs *in, uint32 code, int32 channel)
{
    return code < N64_CODE_ONE ? in->colours[code][channel] : code == N64_CODE_ONE ? 0x100 : 0;
}

static int32 rgb_b(const struct inputs *in, uint32 code, int32 channel)
{
    return code < N64_CODE_KEY_CENTRE ? in->colours[code][channel] : code == N64_CODE_K4 ? in->k4 : 0;
}

static int32 rgb_c(const struct inputs *in, uint32 code, int32 channel)
{
    if (code < N64_CODE_KEY_SCALE)
        return in->colours[code][channel];
    if (code >= N64_CODE_COMBINED_ALPHA && code <= N64_CODE_ENVIRONMENT_ALPHA)
        return in->colours[code - N64_CODE_COMBINED_ALPHA][3];
    return code == N64_CODE_FRACTION ? in->fraction
        : code == N64_CODE_PRIMITIVE_FRACTION ? in->primitive_fraction
        : code == N64_CODE_K5 ? in->k5 : 0;
}

static int32 alpha_abd(const struct inputs *in, uint32 code)
{
    return rgb_ad(in, code, 3);
}

static int32 alpha_c(const struct inputs *in, uint32 code)
{
    return code == N64_CODE_ALPHA_FRACTION ? in->fraction
        : code == N64_CODE_ALPHA_PRIMITIVE_FRACTION ? in->primitive_fraction
        : code < N64_CODE_ONE ? in->colours[code][3] : 0;
}

/* Extends A, B or D: a quarter of the range is negative. */
static int32 extend(int32 value)
{
    value &= 0x1ff;
    return (value & 0x180) == 0x180 ? value - 512 : value;
}

static int32 combine(int32 a, int32 b, int32 c, int32 d)
{
    const int32 sum = (extend(a) - extend(b)) * n64_signed_9(c) + extend(d) * 256 + 0x80;

    return sum >> 8 & 0x1ff;
}

static void combine_cycle(const struct n64_combine *codes, int32 cycle, struct inputs *in)
{
    const struct n64_input *rgb = &codes->rgb[cycle], *alpha = &codes->alpha[cycle];
    int32 made[4];

    for (int32 i = 0; i < 3; i++)
        made[i] = combine(rgb_ad(in, rgb->a, i), rgb_b(in, rgb->b, i), rgb_c(in, rgb->c, i),
                          rgb_ad(in, rgb->d, i));
    made[3] = combine(alpha_abd(in, alpha->a), alpha_abd(in, alpha->b), alpha_c(in, alpha->c),
                      alpha_abd(in, alpha->d));
    for (int32 i = 0; i < 4; i++)
        in->colours[N64_CODE_COMBINED][i] = made[i];
}

static void put(struct inputs *in, int32 code, const struct n64_colour *colour)
{
    in->colours[code][0] = colour->r;
    in->colours[code][1] = colour->g;
    in->colours[code][2] = colour->b;
    in->colours[code][3] = colour->a;
}

/* Clamps 9 bits to 0-255. */
static int32 clamp_9(int32 value)
{
    value &= 0x1ff;
    return (value & 0x180) == 0x180 ? 0 : value & 0x100 ? 255 : value;
}

uint32 n64_combine_pixel(const struct n64 *n64, const struct n64_sources *sources)
{
    struct inputs in;
    uint32 colour = 0;

    for (int32 i = 0; i < 4; i++) {
        in.colours[N64_CODE_COMBINED][i] = 0;
        in.colours[N64_CODE_PRIMITIVE][i] = n64->primitive[i];
        in.colours[N64_CODE_ENVIRONMENT][i] = n64->environment[i];
    }
    put(&in, N64_CODE_SHADE, &sources->shade);
    put(&in, N64_CODE_TEXEL0, &sources->texel0);
    put(&in, N64_CODE_TEXEL1, &sources->texel1);
    in.fraction = sources->fraction;
    in.primitive_fraction = n64->primitive_fraction;
    in.k4 = n64->k[4];
    in.k5 = n64->k[5];
    if (n64->modes.cycle == N64_TWO_CYCLES) {
        combine_cycle(&n64->combine, 0, &in);
        put(&in, N64_CODE_TEXEL0, &sources->texel1);
        put(&in, N64_CODE_TEXEL1, &sources->texel0);
    }
    combine_cycle(&n64->combine, 1, &in);
    for (int32 i = 0; i < 4; i++)
        colour = colour << 8 | (uint32)clamp_9(in.colours[N64_CODE_COMBINED][i]);
    return colour;
}

enum n64_result n64_check_combine(const struct n64_combine *combine)
{
    for (int32 cycle = 0; cycle < 2; cycle++)
        if (combine->rgb[cycle].a == N64_CODE_NOISE || combine->rgb[cycle].b == N64_CODE_KEY_CENTRE
            || combine->rgb[cycle].c == N64_CODE_KEY_SCALE)
            return N64_COMBINE_INPUT;
    return N64_DONE;
}

/* Returns the enum n64_inputs bit of a code that means the same for A, B, C and D. */
static uint32 input_of(uint32 code)
{
    return code == N64_CODE_TEXEL0 ? N64_INPUT_TEXEL0 : code == N64_CODE_TEXEL1 ? N64_INPUT_TEXEL1
        : code == N64_CODE_SHADE ? N64_INPUT_SHADE : 0;
}

static uint32 cycle_inputs(const struct n64_combine *combine, int32 cycle)
{
    const struct n64_input *rgb = &combine->rgb[cycle], *alpha = &combine->alpha[cycle];
    uint32 inputs = input_of(rgb->a) | input_of(rgb->b) | input_of(rgb->c) | input_of(rgb->d)
        | input_of(alpha->a) | input_of(alpha->b) | input_of(alpha->c) | input_of(alpha->d);

    if (rgb->c >= N64_CODE_TEXEL0_ALPHA && rgb->c <= N64_CODE_SHADE_ALPHA)
        inputs |= input_of(rgb->c - N64_CODE_COMBINED_ALPHA);
    if (rgb->c == N64_CODE_FRACTION || alpha->c == N64_CODE_ALPHA_FRACTION)
        inputs |= N64_INPUT_LOD_FRACTION;
    return inputs;
}

/* In one-cycle mode texel 1 is texel 0; in the second of two cycles they change places. Copy mode
   has no combiner. */
void n64_find_inputs(struct n64 *n64)
{
    const uint32 both = N64_INPUT_TEXEL0 | N64_INPUT_TEXEL1;
    uint32 inputs = cycle_inputs(&n64->combine, 1);

    if (n64->modes.cycle != N64_TWO_CYCLES) {
        if (inputs & both)
            inputs = (inputs & ~both) | N64_INPUT_TEXEL0;
    } else {
        if ((inputs & both) == N64_INPUT_TEXEL0 || (inputs & both) == N64_INPUT_TEXEL1)
            inputs ^= both;
        inputs |= cycle_inputs(&n64->combine, 0);
    }
    n64->inputs = n64->modes.cycle == N64_COPY ? N64_INPUT_TEXEL0 : inputs;
}
