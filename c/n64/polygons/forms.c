#include "n64/polygons/forms.h"

#include "limits.h"
#include "n64/codes.h"

#define ZERO_C 16               /* C of R G B is 0 for this code and higher ones */

/* Returns non-zero if a cycle's result is the input of this code, unchanged. */
static int32 is_input(const struct n64_combine *combine, int32 cycle, uint32 code)
{
    const struct n64_input *rgb = &combine->rgb[cycle], *alpha = &combine->alpha[cycle];

    return (rgb->a == rgb->b || rgb->c >= ZERO_C) && rgb->d == code
        && (alpha->a == alpha->b || alpha->c == N64_CODE_ZERO) && alpha->d == code;
}

/* Returns non-zero if the code of A or B of R G B gives 0; COMBINED is 0 in the first cycle. */
static int32 is_zero(const struct n64 *n64, uint32 code)
{
    return code > N64_CODE_ZERO
        || (code == N64_CODE_COMBINED && n64->modes.cycle == N64_ONE_CYCLE);
}

static int32 is_product(const struct n64 *n64, int32 cycle, uint32 code)
{
    const struct n64_input *rgb = &n64->combine.rgb[cycle], *alpha = &n64->combine.alpha[cycle];

    return rgb->a == code && is_zero(n64, rgb->b) && rgb->c == N64_CODE_SHADE
        && rgb->d == N64_CODE_ZERO && alpha->a == code && alpha->b == N64_CODE_ZERO
        && alpha->c == N64_CODE_SHADE && alpha->d == N64_CODE_ZERO;
}

/* Returns non-zero if a code is a constant or the one known input. */
static int32 allowed(uint32 code, uint32 known)
{
    return code == known || (code != N64_CODE_COMBINED && code != N64_CODE_TEXEL0
                             && code != N64_CODE_TEXEL1 && code != N64_CODE_SHADE);
}

/* Returns non-zero if each channel depends only on the same channel of the input of this code. */
static int32 has_tables(const struct n64 *n64, int32 cycle, uint32 code)
{
    const struct n64_input *rgb = &n64->combine.rgb[cycle], *alpha = &n64->combine.alpha[cycle];
    const uint32 c = rgb->c;

    if (c >= N64_CODE_COMBINED_ALPHA && c <= N64_CODE_FRACTION && c != N64_CODE_PRIMITIVE_ALPHA
        && c != N64_CODE_ENVIRONMENT_ALPHA)
        return 0;
    return allowed(rgb->a, code) && allowed(rgb->b, code) && allowed(rgb->d, code)
        && (c > N64_CODE_ENVIRONMENT || allowed(c, code)) && allowed(alpha->a, code)
        && allowed(alpha->b, code) && allowed(alpha->d, code)
        && alpha->c != N64_CODE_ALPHA_FRACTION && allowed(alpha->c, code);
}

/* Finds the second part of a form: the cycle's operation on the input of this code. */
static void find_second(struct n64_form *form, const struct n64 *n64, int32 cycle, uint32 code)
{
    form->cycle = (uint8)cycle;
    if (is_input(&n64->combine, cycle, code))
        form->second = N64_SECOND_NOTHING;
    else if (is_product(n64, cycle, code))
        form->second = N64_SECOND_MODULATE;
    else if (has_tables(n64, cycle, code))
        form->second = N64_SECOND_TABLES;
    else
        form->any = 1;
}

/* Returns a blend's C if it is constant; -1 if it is the level's fraction, -2 if neither. */
static int32 blend_fraction(const struct n64 *n64, const struct n64_input *rgb,
                            const struct n64_input *alpha)
{
    if (rgb->c == N64_CODE_FRACTION && alpha->c == N64_CODE_ALPHA_FRACTION)
        return -1;
    if (rgb->c == N64_CODE_PRIMITIVE_FRACTION && alpha->c == N64_CODE_ALPHA_PRIMITIVE_FRACTION)
        return n64->primitive_fraction;
    if (rgb->c == N64_CODE_PRIMITIVE_ALPHA && alpha->c == N64_CODE_PRIMITIVE)
        return n64->primitive[3];
    if (rgb->c == N64_CODE_ENVIRONMENT_ALPHA && alpha->c == N64_CODE_ENVIRONMENT)
        return n64->environment[3];
    return -2;
}

/* Finds the first cycle as a blend of both texels; returns 0 if it is none. */
static int32 find_blend(struct n64_form *form, const struct n64 *n64)
{
    const struct n64_input *rgb = n64->combine.rgb, *alpha = n64->combine.alpha;
    const int32 fraction = blend_fraction(n64, rgb, alpha);
    const int32 swapped = rgb->a == N64_CODE_TEXEL0;

    if (rgb->a != (swapped ? N64_CODE_TEXEL0 : N64_CODE_TEXEL1)
        || rgb->b != (swapped ? N64_CODE_TEXEL1 : N64_CODE_TEXEL0) || rgb->d != rgb->b
        || alpha->a != rgb->a || alpha->b != rgb->b || alpha->d != rgb->b || fraction < -1)
        return 0;
    form->swapped = (uint8)swapped;
    form->fraction = (int16)fraction;
    form->first = N64_FIRST_BLEND;
    return 1;
}

void n64_form_find(struct n64_form *form, const struct n64 *n64)
{
    form->any = form->swapped = 0;
    form->first = N64_FIRST_TEXEL;
    form->second = N64_SECOND_NOTHING;
    form->fraction = 0;
    form->cycle = 1;
    if (n64->modes.cycle == N64_ONE_CYCLE) {
        find_second(form, n64, 1, N64_CODE_TEXEL0);
    } else if (is_input(&n64->combine, 1, N64_CODE_COMBINED)) {
        if (!find_blend(form, n64))
            find_second(form, n64, 0, N64_CODE_TEXEL0);
    } else if (is_input(&n64->combine, 0, N64_CODE_TEXEL0)
               || (find_blend(form, n64) && !n64->modes.sharpen)) {
        /* A sharpened blend may leave 0 to 255 between the cycles. */
        find_second(form, n64, 1, N64_CODE_COMBINED);
    } else {
        form->first = N64_FIRST_TEXEL;
        find_second(form, n64, 1, N64_CODE_TEXEL0);
        form->swapped = !form->any;
    }
}

/* The constants of the combiner's codes. */
struct constants {
    struct n64_wide primitive, environment, one, zero;
    int16 primitive_fraction, k4, k5;
};

/* A cycle's inputs. */
struct inputs {
    const struct n64 *n64;
    const struct n64_places *from;
    int32 cycle;
    struct constants constants;
};

/* Extends 9 bits as A, B and D do. */
static int16 extended(int32 value)
{
    value &= 0x1ff;
    return (int16)((value & 0x180) == 0x180 ? value - 512 : value);
}

static void set_constants(struct constants *to, const struct n64 *n64)
{
    for (int32 i = 0; i < 4; i++) {
        to->primitive.channels[i] = n64->primitive[i];
        to->environment.channels[i] = n64->environment[i];
        to->one.channels[i] = 0x100;
        to->zero.channels[i] = 0;
    }
    to->primitive_fraction = n64->primitive_fraction;
    to->k4 = extended(n64->k[4]);
    to->k5 = n64->k[5];
}

/* Where a cycle's input is, and bytes from pixel to pixel. */
struct place {
    const int16 *at;
    int32 step;
};

static struct place constant(const int16 *at)
{
    struct place place;

    place.at = at;
    place.step = 0;
    return place;
}

/* A code up to ONE; texel 0 and 1 change places in the second of two cycles. */
static struct place colour(const struct inputs *in, uint32 code, int32 channel)
{
    const int32 second = in->cycle && in->n64->modes.cycle == N64_TWO_CYCLES;
    const struct n64_places *from = in->from;
    struct place place;

    place.step = sizeof(struct n64_wide);
    switch (code) {
    case N64_CODE_COMBINED:
        if (!second)
            return constant(in->constants.zero.channels);
        place.at = &from->combined->channels[channel];
        return place;
    case N64_CODE_TEXEL0:
    case N64_CODE_TEXEL1:
        place.at = (code == N64_CODE_TEXEL0) != second ? &from->texel0->channels[channel]
                                                      : &from->texel1->channels[channel];
        return place;
    case N64_CODE_SHADE:
        place.at = &from->shade->channels[channel];
        place.step = from->shade_step;
        return place;
    case N64_CODE_PRIMITIVE:
        return constant(&in->constants.primitive.channels[channel]);
    case N64_CODE_ENVIRONMENT:
        return constant(&in->constants.environment.channels[channel]);
    case N64_CODE_ONE:
        return constant(in->constants.one.channels);
    default:
        return constant(in->constants.zero.channels);
    }
}

static struct place level(const struct inputs *in)
{
    struct place place;

    place.at = in->from->fraction;
    place.step = in->from->fraction_step;
    return place;
}

static struct place rgb_b(const struct inputs *in, uint32 code, int32 channel)
{
    return code == N64_CODE_K4 ? constant(&in->constants.k4)
         : colour(in, code < N64_CODE_ONE ? code : N64_CODE_ZERO, channel);
}

static struct place rgb_c(const struct inputs *in, uint32 code, int32 channel)
{
    if (code <= N64_CODE_ENVIRONMENT)
        return colour(in, code, channel);
    if (code >= N64_CODE_COMBINED_ALPHA && code <= N64_CODE_ENVIRONMENT_ALPHA)
        return colour(in, code - N64_CODE_COMBINED_ALPHA, 3);
    return code == N64_CODE_FRACTION ? level(in)
         : code == N64_CODE_PRIMITIVE_FRACTION ? constant(&in->constants.primitive_fraction)
         : code == N64_CODE_K5 ? constant(&in->constants.k5)
         : constant(in->constants.zero.channels);
}

static struct place alpha_c(const struct inputs *in, uint32 code)
{
    return code == N64_CODE_ALPHA_FRACTION ? level(in)
         : code == N64_CODE_ALPHA_PRIMITIVE_FRACTION ? constant(&in->constants.primitive_fraction)
         : colour(in, code, 3);
}

static void find_inputs(struct n64_combination *to, const struct inputs *in, int32 channel)
{
    const struct n64_combine *combine = &in->n64->combine;
    const struct n64_input *codes = channel < 3 ? &combine->rgb[in->cycle]
                                               : &combine->alpha[in->cycle];
    struct place a = colour(in, codes->a, channel), b, c;
    struct place d = colour(in, codes->d, channel);

    b = channel < 3 ? rgb_b(in, codes->b, channel) : colour(in, codes->b, 3);
    c = channel < 3 ? rgb_c(in, codes->c, channel) : alpha_c(in, codes->c);
    to->a = a.at;
    to->a_step = a.step;
    to->b = b.at;
    to->b_step = b.step;
    to->c = c.at;
    to->c_step = c.step;
    to->d = d.at;
    to->d_step = d.step;
}

void n64_combine_cycle(const struct n64 *n64, const struct n64_places *at, int32 cycle,
                       struct n64_wide *results, int32 count)
{
    struct n64_combination combination;
    struct inputs in;

    in.n64 = n64;
    in.from = at;
    in.cycle = cycle;
    set_constants(&in.constants, n64);
    for (int32 channel = 0; channel < 4; channel++) {
        find_inputs(&combination, &in, channel);
        n64_combiner(0, &results->channels[channel], &combination, count);
    }
}

void n64_combine_line(const struct n64 *n64, const struct n64_places *at,
                      struct n64_wide (*results)[N64_LINE_PIXELS], uint32 *colours, int32 count)
{
    struct n64_places places = *at;

    if (n64->modes.cycle == N64_TWO_CYCLES) {
        n64_combine_cycle(n64, &places, 0, results[0], count);
        places.combined = results[0];
    }
    n64_combine_cycle(n64, &places, 1, results[1], count);
    n64_narrow(results[1], colours, 0, count);
}
