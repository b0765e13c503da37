/* The colour combiner: (A - B) * C + D in 9 bits, once or twice. */
#include "n64/bits.h"
#include "n64/codes.h"
#include "n64/pixel.h"

const uint8 n64_sources[4][16] = {
    {0, 1, 2, 3, 4, 5, N64_ONE, 7, 7, 7, 7, 7, 7, 7, 7, 7},
    {0, 1, 2, 3, 4, 5, 7, N64_K4, 7, 7, 7, 7, 7, 7, 7, 7},
    {0, 1, 2, 3, 4, 5, 7, 16, 17, 18, 19, 20, 21, N64_FRACTION, N64_PRIMITIVE_FRACTION, N64_K5},
    {N64_FRACTION, 1, 2, 3, 4, 5, N64_PRIMITIVE_FRACTION, 7, 7, 7, 7, 7, 7, 7, 7, 7}
};

/* Values of sources; channel 0-3: R G B A. */
struct inputs {
    int32 colours[6][4];
    int32 singles[6];           /* N64_ONE to N64_K5 */
};

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

/* Makes channels first to end - 1 from an input of R G B or of alpha. */
static void combine_channels(const struct inputs *in, const struct n64_input *codes, int32 first,
                             int32 end, int32 *made)
{
    const int32 *from[4];
    int32 steps[4];

    for (int32 which = 0; which < 4; which++) {
        const uint32 source = n64_source(codes, first == 3, which);

        steps[which] = source < N64_ONE;
        from[which] = source < N64_ONE ? &in->colours[source][first]
            : source >= N64_ALPHA_OF ? &in->colours[source - N64_ALPHA_OF][3]
            : &in->singles[source - N64_ONE];
    }
    for (int32 i = first; i < end; i++) {
        made[i] = combine(*from[N64_A], *from[N64_B], *from[N64_C], *from[N64_D]);
        for (int32 which = 0; which < 4; which++)
            from[which] += steps[which];
    }
}

static void combine_cycle(const struct n64_combine *codes, int32 cycle, struct inputs *in)
{
    int32 made[4];

    combine_channels(in, &codes->rgb[cycle], 0, 3, made);
    combine_channels(in, &codes->alpha[cycle], 3, 4, made);
    for (int32 i = 0; i < 4; i++)
        in->colours[N64_COMBINED][i] = made[i];
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
        in.colours[N64_COMBINED][i] = 0;
        in.colours[N64_PRIMITIVE][i] = n64->primitive[i];
        in.colours[N64_ENVIRONMENT][i] = n64->environment[i];
    }
    put(&in, N64_SHADE, &sources->shade);
    put(&in, N64_TEXEL0, &sources->texel0);
    put(&in, N64_TEXEL1, &sources->texel1);
    in.singles[0] = 0x100;
    in.singles[N64_ZERO - N64_ONE] = 0;
    in.singles[N64_FRACTION - N64_ONE] = sources->fraction;
    in.singles[N64_PRIMITIVE_FRACTION - N64_ONE] = n64->primitive_fraction;
    in.singles[N64_K4 - N64_ONE] = n64->k[4];
    in.singles[N64_K5 - N64_ONE] = n64->k[5];
    if (n64->modes.cycle == N64_TWO_CYCLES) {
        combine_cycle(&n64->combine, 0, &in);
        put(&in, N64_TEXEL0, &sources->texel1);
        put(&in, N64_TEXEL1, &sources->texel0);
    }
    combine_cycle(&n64->combine, 1, &in);
    for (int32 i = 0; i < 4; i++)
        colour = colour << 8 | (uint32)clamp_9(in.colours[N64_COMBINED][i]);
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

static uint32 cycle_inputs(const struct n64_combine *combine, int32 cycle)
{
    static const uint8 of[] = {0, N64_INPUT_TEXEL0, N64_INPUT_TEXEL1, 0, N64_INPUT_SHADE, 0};
    uint32 inputs = 0;

    for (int32 i = 0; i < 8; i++) {
        const uint32 source = n64_source(i < 4 ? &combine->rgb[cycle] : &combine->alpha[cycle],
                                         i >= 4, i & 3);
        const uint32 colour = source < N64_ALPHA_OF ? source : source - N64_ALPHA_OF;

        inputs |= source == N64_FRACTION ? N64_INPUT_LOD_FRACTION
            : colour < N64_ONE ? of[colour] : 0;
    }
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
