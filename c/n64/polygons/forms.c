#include "n64/polygons/forms.h"

#include "limits.h"
#include "n64/codes.h"

/* Sources that are the same for all pixels. */
#define CONSTANTS (1u << N64_PRIMITIVE | 1u << N64_ENVIRONMENT | 1u << N64_ONE | 1u << N64_ZERO \
    | 1u << N64_PRIMITIVE_FRACTION | 1u << N64_K4 | 1u << N64_K5 \
    | 1u << (N64_ALPHA_OF + N64_PRIMITIVE) | 1u << (N64_ALPHA_OF + N64_ENVIRONMENT))

/* Returns non-zero if (A - B) C + D is this source, unchanged. */
static int32 is_only(const uint8 *of, uint32 source)
{
    return (of[N64_A] == of[N64_B] || of[N64_C] == N64_ZERO) && of[N64_D] == source;
}

int32 n64_form_is_input(const struct n64 *n64, int32 cycle, uint32 source)
{
    const uint8 *of = n64->sources[cycle];

    return is_only(of, source) && is_only(of + N64_OF_ALPHA, source);
}

/* Returns non-zero if (A - B) C + D is the product of two sources. no_combined: COMBINED is 0. */
static int32 is_product(const uint8 *of, uint32 a, uint32 c, int32 no_combined)
{
    return of[N64_A] == a && of[N64_C] == c && of[N64_D] == N64_ZERO
        && (of[N64_B] == N64_ZERO || (of[N64_B] == N64_COMBINED && no_combined));
}

/* Returns non-zero if each channel depends only on the same channel of this source. */
static int32 has_tables(const uint8 *of, uint32 source)
{
    for (int32 i = 0; i < 4; i++)
        if (of[i] != source && !(CONSTANTS >> of[i] & 1))
            return 0;
    return 1;
}

/* Finds the second part of a form: the cycle's operation on this source. */
static void find_second(struct n64_form *form, const struct n64 *n64, int32 cycle, uint32 source)
{
    const uint8 *rgb = n64->sources[cycle], *alpha = rgb + N64_OF_ALPHA;
    const int32 is_one = n64->modes.cycle == N64_ONE_CYCLE;

    form->cycle = (uint8)cycle;
    if (is_only(rgb, source) && is_only(alpha, source))
        form->second = N64_SECOND_NOTHING;
    else if (is_product(rgb, source, N64_SHADE, is_one)
             && is_product(alpha, source, N64_SHADE, is_one))
        form->second = N64_SECOND_MODULATE;
    else if (has_tables(rgb, source) && has_tables(alpha, source))
        form->second = N64_SECOND_TABLES;
    else
        form->any = 1;
}

/* Returns a blend's C if it is constant; -1 if it is the level's fraction, -2 if neither. */
static int32 blend_fraction(const struct n64 *n64, uint32 rgb, uint32 alpha)
{
    if (rgb == N64_FRACTION && alpha == N64_FRACTION)
        return -1;
    if (rgb == N64_PRIMITIVE_FRACTION && alpha == N64_PRIMITIVE_FRACTION)
        return n64->primitive_fraction;
    if (rgb == N64_ALPHA_OF + alpha && alpha == N64_PRIMITIVE)
        return n64->primitive[3];
    if (rgb == N64_ALPHA_OF + alpha && alpha == N64_ENVIRONMENT)
        return n64->environment[3];
    return -2;
}

static int32 is_blend(const uint8 *of, uint32 from, uint32 to)
{
    return of[N64_A] == to && of[N64_B] == from && of[N64_D] == from;
}

/* Finds the first cycle as a blend of both texels; returns 0 if it is none. */
static int32 find_blend(struct n64_form *form, const struct n64 *n64)
{
    const uint8 *rgb = n64->sources[0], *alpha = rgb + N64_OF_ALPHA;
    const int32 fraction = blend_fraction(n64, rgb[N64_C], alpha[N64_C]);
    const int32 swapped = rgb[N64_A] == N64_TEXEL0;
    const uint32 from = swapped ? N64_TEXEL1 : N64_TEXEL0, to = swapped ? N64_TEXEL0 : N64_TEXEL1;

    if (!is_blend(rgb, from, to) || !is_blend(alpha, from, to) || fraction < -1)
        return 0;
    form->swapped = (uint8)swapped;
    form->fraction = (int16)fraction;
    form->first = N64_FIRST_BLEND;
    return 1;
}

static int32 is_texels_product(const uint8 *of)
{
    return is_product(of, N64_TEXEL0, N64_TEXEL1, 1) || is_product(of, N64_TEXEL1, N64_TEXEL0, 1);
}

/* Finds the first cycle as the product of both texels, 0 to 254; returns 0 if it is none. */
static int32 find_product(struct n64_form *form, const struct n64 *n64)
{
    const uint8 *rgb = n64->sources[0];

    if (!is_texels_product(rgb) || !is_texels_product(rgb + N64_OF_ALPHA))
        return 0;
    form->first = N64_FIRST_PRODUCT;
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
        find_second(form, n64, 1, N64_TEXEL0);
    } else if (n64_form_is_input(n64, 1, N64_COMBINED)) {
        if (!find_blend(form, n64) && !find_product(form, n64))
            find_second(form, n64, 0, N64_TEXEL0);
    } else if (n64_form_is_input(n64, 0, N64_TEXEL0)
               || (find_blend(form, n64) && !n64->modes.sharpen) || find_product(form, n64)) {
        /* A sharpened blend may leave 0 to 255 between the cycles. */
        find_second(form, n64, 1, N64_COMBINED);
    } else {
        form->first = N64_FIRST_TEXEL;
        find_second(form, n64, 1, N64_TEXEL0);
        form->swapped = 1;
    }
    if (form->any) {            /* the combiner blends */
        form->first = N64_FIRST_TEXEL;
        form->swapped = 0;
    }
}

/* Where a source is: from pixel to pixel a step in bytes, from channel to channel one in words. */
struct place {
    const int16 *at;
    int32 step, across;
};

/* Extends 9 bits as A, B and D do. */
static int16 extended(int32 value)
{
    value &= 0x1ff;
    return (int16)((value & 0x180) == 0x180 ? value - 512 : value);
}

static void set_place(struct place *to, const int16 *at, int32 step, int32 across)
{
    to->at = at;
    to->step = step;
    to->across = across;
}

/* Finds all sources of a cycle. COMBINED is 0 in the first one; texel 0 and 1 change places in the
   second of two. */
static void find_places(struct place *to, const struct n64_places *from, int32 is_second,
                        const struct n64_combiner_plan *plan)
{
    const int16 *singles = plan->singles;
    const int32 step = sizeof(struct n64_wide);
    const struct n64_wide *texel0 = is_second ? from->texel1 : from->texel0;
    const struct n64_wide *texel1 = is_second ? from->texel0 : from->texel1;

    for (int32 source = N64_ONE; source <= N64_K5; source++)
        set_place(&to[source], singles++, 0, 0);
    to[N64_COMBINED] = to[N64_ZERO];
    if (is_second)
        set_place(&to[N64_COMBINED], from->combined->channels, step, 1);
    set_place(&to[N64_TEXEL0], texel0->channels, step, 1);
    set_place(&to[N64_TEXEL1], texel1->channels, step, 1);
    set_place(&to[N64_PRIMITIVE], plan->primitive.channels, 0, 1);
    set_place(&to[N64_SHADE], from->shade->channels, from->shade_step, 1);
    set_place(&to[N64_ENVIRONMENT], plan->environment.channels, 0, 1);
    set_place(&to[N64_FRACTION], from->fraction, from->fraction_step, 0);
}

static const int16 *place(const struct place *places, uint32 source, int32 channel, int32 *step)
{
    if (source >= N64_ALPHA_OF) {
        source -= N64_ALPHA_OF;
        channel = 3;
    }
    *step = places[source].step;
    return places[source].at + (places[source].across ? channel : 0);
}

void n64_combiner_begin(struct n64_combiner_plan *plan, const struct n64 *n64)
{
    for (int32 i = 0; i < 4; i++) {
        plan->primitive.channels[i] = n64->primitive[i];
        plan->environment.channels[i] = n64->environment[i];
    }
    plan->singles[0] = 0x100;
    plan->singles[N64_ZERO - N64_ONE] = 0;
    plan->singles[N64_FRACTION - N64_ONE] = 0;
    plan->singles[N64_PRIMITIVE_FRACTION - N64_ONE] = n64->primitive_fraction;
    plan->singles[N64_K4 - N64_ONE] = extended(n64->k[4]);
    plan->singles[N64_K5 - N64_ONE] = n64->k[5];
}

void n64_combiner_find(struct n64_combiner_plan *plan, const struct n64 *n64,
                       const struct n64_places *at, int32 cycle)
{
    const int32 is_second = cycle && n64->modes.cycle == N64_TWO_CYCLES;
    const uint8 *of = n64->sources[cycle];
    struct place places[N64_K5 + 1];

    find_places(places, at, is_second, plan);
    for (int32 channel = 0; channel < 4; channel++) {
        struct n64_combination *to = &plan->of[cycle][channel];

        if (channel == 3)
            of += N64_OF_ALPHA;
        to->a = place(places, of[N64_A], channel, &to->a_step);
        to->b = place(places, of[N64_B], channel, &to->b_step);
        to->c = place(places, of[N64_C], channel, &to->c_step);
        to->d = place(places, of[N64_D], channel, &to->d_step);
    }
}

void n64_combine_cycle(const struct n64 *n64, const struct n64_places *at, int32 cycle,
                       struct n64_wide *results, int32 count)
{
    struct n64_combiner_plan plan;

    n64_combiner_begin(&plan, n64);
    n64_combiner_find(&plan, n64, at, cycle);
    for (int32 channel = 0; channel < 4; channel++)
        n64_combiner(0, &results->channels[channel], &plan.of[cycle][channel], count);
}
