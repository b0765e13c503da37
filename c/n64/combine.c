/* The colour combiner: (A - B) * C + D in 9 bits, once or twice. */
#include "n64/bits.h"
#include "n64/codes.h"
#include "n64/pixel.h"

/* By codes below 16: of A and D of R G B and A, B and D of alpha, of B and C of R G B, of C of
   alpha. All higher codes are N64_ZERO. */
static const uint8 selected[4][16] = {
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

static int32 value(const struct inputs *in, uint32 source, int32 channel)
{
    return source < N64_ONE ? in->colours[source][channel]
        : source < N64_ALPHA_OF ? in->singles[source - N64_ONE]
        : in->colours[source - N64_ALPHA_OF][3];
}

static void combine_cycle(const uint8 *of, struct inputs *in)
{
    int32 made[4];

    for (int32 i = 0; i < 4; i++) {
        if (i == 3)
            of += N64_OF_ALPHA;
        made[i] = combine(value(in, of[N64_A], i), value(in, of[N64_B], i),
                          value(in, of[N64_C], i), value(in, of[N64_D], i));
    }
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
        combine_cycle(n64->sources[0], &in);
        put(&in, N64_TEXEL0, &sources->texel1);
        put(&in, N64_TEXEL1, &sources->texel0);
    }
    combine_cycle(n64->sources[1], &in);
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

static void find_sources(uint8 *to, const struct n64_input *input, int32 is_alpha)
{
    for (int32 which = 0; which < 4; which++) {
        const uint32 code = (&input->a)[which];
        const int32 row = which == N64_C ? 2 + is_alpha : which == N64_B && !is_alpha;

        to[which] = code < 16 ? selected[row][code] : N64_ZERO;
    }
}

static uint32 cycle_inputs(struct n64 *n64, int32 cycle)
{
    uint8 *of = n64->sources[cycle];
    static const uint8 bits[] = {0, N64_INPUT_TEXEL0, N64_INPUT_TEXEL1, 0, N64_INPUT_SHADE, 0};
    uint32 inputs = 0;

    find_sources(of, &n64->combine.rgb[cycle], 0);
    find_sources(of + N64_OF_ALPHA, &n64->combine.alpha[cycle], 1);
    for (int32 i = 0; i < 8; i++) {
        const uint32 colour = of[i] < N64_ALPHA_OF ? of[i] : of[i] - N64_ALPHA_OF;

        inputs |= of[i] == N64_FRACTION ? N64_INPUT_LOD_FRACTION
            : colour < N64_ONE ? bits[colour] : 0;
    }
    return inputs;
}

/* In one-cycle mode texel 1 is texel 0; in the second of two cycles they change places. Copy mode
   has no combiner. */
void n64_find_inputs(struct n64 *n64)
{
    const uint32 both = N64_INPUT_TEXEL0 | N64_INPUT_TEXEL1;
    const uint32 first = cycle_inputs(n64, 0);
    uint32 inputs = cycle_inputs(n64, 1);

    if (n64->modes.cycle != N64_TWO_CYCLES) {
        if (inputs & both)
            inputs = (inputs & ~both) | N64_INPUT_TEXEL0;
    } else {
        if ((inputs & both) == N64_INPUT_TEXEL0 || (inputs & both) == N64_INPUT_TEXEL1)
            inputs ^= both;
        inputs |= first;
    }
    n64->inputs = n64->modes.cycle == N64_COPY ? N64_INPUT_TEXEL0 : inputs;
}
