/* The combine unit over a line, by passes chosen for the terms. */
#include "glide/polygons/plan.h"

struct line {
    struct glide_lines *lines;  /* that passes are added to; null: they are called */
    const struct glide_combining *combining;
    const struct glide_modes *modes;
    const struct glide_factors *factors;
    const uint32 *local, *other;
    uint32 *to;
    int32 count;
};

enum { ALPHA = 3 };             /* of R G B A */

static const uint8 none = 0;

static void apply(const struct line *line, glide_pass *pass, const void *in, void *out,
                  const void *constants, uint32 bytes)
{
    if (line->lines)
        glide_lines_add(line->lines, pass, in, out, constants, bytes);
    else
        pass(in, out, constants, line->count);
}

/* The bytes of a channel: *bytes is the first, *step from one to the next; or 0 for all pixels. */
static void set_zero(const uint8 **bytes, int32 *step)
{
    *bytes = &none;
    *step = 0;
}

static void set_channel(const uint8 **bytes, int32 *step, const uint32 *texels, int32 number)
{
    *bytes = (const uint8 *)texels + number;
    *step = 4;
}

static void set_factor(const uint8 **bytes, int32 *step, const struct glide_combination *by,
                       const struct line *line, int32 number)
{
    set_zero(bytes, step);
    switch (by->mselect) {
    case GLIDE_FACTOR_LOCAL: set_channel(bytes, step, line->local, number); break;
    case GLIDE_FACTOR_OTHER_ALPHA:
        if (line->other)
            set_channel(bytes, step, line->other, ALPHA);
        break;
    case GLIDE_FACTOR_LOCAL_ALPHA: set_channel(bytes, step, line->local, ALPHA); break;
    case GLIDE_FACTOR_DETAIL:
        *bytes = line->factors->details;
        *step = line->factors->detail_step;
        break;
    case GLIDE_FACTOR_LOD_FRACTION:
        *bytes = line->factors->fractions;
        *step = line->factors->fraction_step;
        break;
    }
}

/* Combines a channel by any function. */
static void combine_channel(const struct line *line, const struct glide_combination *by,
                            int32 number)
{
    struct glide_inputs in;

    set_zero(&in.other, &in.other_step);
    set_zero(&in.local, &in.local_step);
    set_zero(&in.added, &in.added_step);
    if (!by->zero_other && line->other)
        set_channel(&in.other, &in.other_step, line->other, number);
    if (by->sub_local)
        set_channel(&in.local, &in.local_step, line->local, number);
    set_factor(&in.factor, &in.factor_step, by, line, number);
    if (by->add_alpha_local)
        set_channel(&in.added, &in.added_step, line->local, ALPHA);
    else if (by->add_local)
        set_channel(&in.added, &in.added_step, line->local, number);
    in.flip = (uint16)(line->factors->flip ^ (by->reverse ? 0 : 255));
    in.invert = by->invert ? 255 : 0;
    apply(line, glide_combiner, 0, (uint8 *)line->to + number, &in, sizeof in);
}

static void open_mix(struct glide_mix *mix, const struct line *line)
{
    const struct glide_combination *by = &line->modes->rgb;

    set_factor(&mix->factors, &mix->factor_step, by, line, ALPHA);
    mix->other = line->local;
    mix->other_step = 4;
    mix->flip = (line->factors->flip ^ (by->reverse ? 0u : 255u)) * 0x01010101;
    mix->one = 1;
}

/* Combines all channels by colour's term; returns the resulting texels. */
static const uint32 *combine_texels(const struct line *line)
{
    const enum glide_term term = line->combining->rgb;
    const uint32 *from = line->other;
    struct glide_mix mix;

    if (term == GLIDE_TERM_LOCAL || term == GLIDE_TERM_OTHER)
        return term == GLIDE_TERM_LOCAL ? line->local : line->other;
    open_mix(&mix, line);
    switch (term) {
    case GLIDE_TERM_REST:               /* 256 - (m + 1) is m inverted */
        mix.flip = ~mix.flip;
        mix.one = 0;
        apply(line, glide_scale, line->local, line->to, &mix, sizeof mix);
        break;
    case GLIDE_TERM_BLEND:
        mix.other = line->other;
        apply(line, glide_lerp, line->local, line->to, &mix, sizeof mix);
        break;
    case GLIDE_TERM_SCALED:
    case GLIDE_TERM_SCALED_SUM: apply(line, glide_scale, from, line->to, &mix, sizeof mix); break;
    case GLIDE_TERM_PRODUCT:
    case GLIDE_TERM_PRODUCT_SUM:
        if (line->combining->alpha_way == GLIDE_ALPHA_ALIKE)
            apply(line, glide_modulate, from, line->to, &mix, sizeof mix);
        else
            apply(line, glide_modulate_rgb, from, line->to, &mix, sizeof mix);
        break;
    default:
        break;
    }
    if (term == GLIDE_TERM_SCALED_SUM || term == GLIDE_TERM_PRODUCT_SUM)
        from = line->to;
    else if (term != GLIDE_TERM_SUM)
        return line->to;
    apply(line, glide_add, from, line->to, &mix, sizeof mix);
    return line->to;
}

/* Makes the result from combined texels: copies or replaces alpha and inverts channels. */
static void finish(const struct line *line, const uint32 *texels)
{
    const struct glide_combining *combining = line->combining;
    struct glide_alphas alphas;

    set_channel(&alphas.alphas, &alphas.step, texels, ALPHA);
    if (combining->alpha_way == GLIDE_ALPHA_TAKEN && combining->alpha == GLIDE_TERM_ZERO)
        set_zero(&alphas.alphas, &alphas.step);
    else if (combining->alpha_way == GLIDE_ALPHA_TAKEN)
        set_channel(&alphas.alphas, &alphas.step,
                    combining->alpha == GLIDE_TERM_LOCAL ? line->local : line->other, ALPHA);
    else if (texels == line->to && !combining->inverted)
        return;
    alphas.inverted = combining->inverted;
    if (line->lines && (uint32)alphas.alphas < GLIDE_PIXEL_PLACES)
        line->lines->is_full = 1;       /* data has no place in the frame */
    apply(line, glide_alpha, texels, line->to, &alphas, sizeof alphas);
}

static void combine(struct glide_lines *lines, const struct glide_combining *combining,
                    const struct glide_modes *modes, const struct glide_factors *factors,
                    const uint32 *local, const uint32 *other, uint32 *to, int32 count)
{
    const uint32 *texels = to;
    struct line line;

    line.lines = lines;
    line.combining = combining;
    line.modes = modes;
    line.factors = factors;
    line.local = local;
    line.other = other;
    line.to = to;
    line.count = count;
    if (combining->rgb == GLIDE_TERM_ANY)
        for (int32 number = 0; number < ALPHA; number++)
            combine_channel(&line, &modes->rgb, number);
    else
        texels = combine_texels(&line);
    finish(&line, texels);
    if (combining->alpha_way == GLIDE_ALPHA_COMBINED)
        combine_channel(&line, &modes->alpha, ALPHA);
}

void glide_combine_line(const struct glide_combining *combining, const struct glide_modes *modes,
                        const struct glide_factors *factors, const uint32 *local,
                        const uint32 *other, uint32 *to, int32 count)
{
    combine(0, combining, modes, factors, local, other, to, count);
}

void glide_combine_add(struct glide_lines *lines, const struct glide_combining *combining,
                       const struct glide_modes *modes, const struct glide_factors *factors,
                       const uint32 *local, const uint32 *other, uint32 *to)
{
    combine(lines, combining, modes, factors, local, other, to, 0);
}
