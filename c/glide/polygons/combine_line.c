/* The combine unit over a line, by passes chosen for the terms. */
#include "glide/polygons/plan.h"

/* The bytes of a channel: one from each texel, or one for all pixels. */
struct bytes {
    const uint8 *at;
    int32 step;
};

struct line {
    const struct glide_combining *combining;
    const struct glide_modes *modes;
    const struct glide_factors *factors;
    const uint32 *local, *other;
    uint32 *to;
    int32 count;
};

static void set_constant(struct bytes *bytes, const uint8 *byte)
{
    bytes->at = byte;
    bytes->step = 0;
}

static void set_channel(struct bytes *bytes, const uint32 *texels, int32 number)
{
    bytes->at = (const uint8 *)texels + number;
    bytes->step = 4;
}

enum { ALPHA = 3 };             /* of R G B A */

static const uint8 none = 0;

static void set_factor(struct bytes *bytes, const struct glide_combination *by,
                       const struct line *line, int32 number)
{
    set_constant(bytes, &none);
    switch (by->mselect) {
    case GLIDE_FACTOR_LOCAL: set_channel(bytes, line->local, number); break;
    case GLIDE_FACTOR_OTHER_ALPHA:
        if (line->other)
            set_channel(bytes, line->other, ALPHA);
        break;
    case GLIDE_FACTOR_LOCAL_ALPHA: set_channel(bytes, line->local, ALPHA); break;
    case GLIDE_FACTOR_DETAIL:
        bytes->at = line->factors->details;
        bytes->step = line->factors->detail_step;
        break;
    case GLIDE_FACTOR_LOD_FRACTION:
        bytes->at = line->factors->fractions;
        bytes->step = line->factors->fraction_step;
        break;
    }
}

static void set_added(struct bytes *bytes, const struct glide_combination *by, const uint32 *local,
                      int32 number)
{
    if (by->add_alpha_local || (number == ALPHA && by->add_local))
        set_channel(bytes, local, ALPHA);
    else if (by->add_local)
        set_channel(bytes, local, number);
    else
        set_constant(bytes, &none);
}

/* Combines a channel by any function. */
static void combine_channel(const struct line *line, const struct glide_combination *by,
                            int32 number)
{
    struct bytes from, less, m, plus;
    struct glide_inputs inputs;

    set_constant(&from, &none);
    set_constant(&less, &none);
    if (!by->zero_other && line->other)
        set_channel(&from, line->other, number);
    if (by->sub_local)
        set_channel(&less, line->local, number);
    set_factor(&m, by, line, number);
    set_added(&plus, by, line->local, number);
    inputs.other = from.at;
    inputs.other_step = from.step;
    inputs.local = less.at;
    inputs.local_step = less.step;
    inputs.factor = m.at;
    inputs.factor_step = m.step;
    inputs.added = plus.at;
    inputs.added_step = plus.step;
    inputs.flip = (uint16)(line->factors->flip ^ (by->reverse ? 0 : 255));
    inputs.invert = by->invert ? 255 : 0;
    glide_combiner(0, (uint8 *)line->to + number, &inputs, line->count);
}

static void open_mix(struct glide_mix *mix, const struct line *line)
{
    const struct glide_combination *by = &line->modes->rgb;
    struct bytes factor;

    set_factor(&factor, by, line, ALPHA);
    mix->factors = factor.at;
    mix->factor_step = factor.step;
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
        glide_scale(line->local, line->to, &mix, line->count);
        break;
    case GLIDE_TERM_BLEND:
        mix.other = line->other;
        glide_lerp(line->local, line->to, &mix, line->count);
        break;
    case GLIDE_TERM_SCALED:
    case GLIDE_TERM_SCALED_SUM: glide_scale(from, line->to, &mix, line->count); break;
    case GLIDE_TERM_PRODUCT:
    case GLIDE_TERM_PRODUCT_SUM:
        if (line->combining->alpha_way == GLIDE_ALPHA_ALIKE)
            glide_modulate(from, line->to, &mix, line->count);
        else
            glide_modulate_rgb(from, line->to, &mix, line->count);
        break;
    default:
        break;
    }
    if (term == GLIDE_TERM_SCALED_SUM || term == GLIDE_TERM_PRODUCT_SUM)
        from = line->to;
    if (from == line->to || term == GLIDE_TERM_SUM)
        glide_add(from, line->to, &mix, line->count);
    return line->to;
}

/* Makes the result from combined texels: copies or replaces alpha and inverts channels. */
static void finish(const struct line *line, const uint32 *texels)
{
    const struct glide_combining *combining = line->combining;
    struct glide_alphas alphas;
    struct bytes from;

    set_channel(&from, texels, ALPHA);
    if (combining->alpha_way == GLIDE_ALPHA_TAKEN && combining->alpha == GLIDE_TERM_ZERO)
        set_constant(&from, &none);
    else if (combining->alpha_way == GLIDE_ALPHA_TAKEN)
        set_channel(&from, combining->alpha == GLIDE_TERM_LOCAL ? line->local : line->other, ALPHA);
    else if (texels == line->to && !combining->inverted)
        return;
    alphas.alphas = from.at;
    alphas.step = from.step;
    alphas.inverted = combining->inverted;
    glide_alpha(texels, line->to, &alphas, line->count);
}

void glide_combine_line(const struct glide_combining *combining, const struct glide_modes *modes,
                        const struct glide_factors *factors, const uint32 *local,
                        const uint32 *other, uint32 *to, int32 count)
{
    const uint32 *texels = to;
    struct line line;

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
