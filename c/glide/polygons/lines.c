/* Finds the passes of a polygon all of whose lines have the same ones. */
#include "glide/polygons/plan.h"

void glide_lines_stage(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                       const void *constants)
{
    struct glide_stage *stage = &lines->stages[lines->last_stage];

    if (lines->last_stage == GLIDE_STAGES) {
        lines->is_full = 1;
        return;
    }
    stage->in = in;
    stage->out = out;
    stage->constants = constants;
    stage->pass = pass;
    lines->last_stage++;
}

void glide_lines_add(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                     const void *constants, uint32 bytes)
{
    uint32 *to = lines->constants + lines->longs;
    const uint32 *from = constants;

    if (lines->longs + bytes / 4 > GLIDE_STAGE_LONGS) {
        lines->is_full = 1;
        return;
    }
    for (uint32 n = bytes / 4; n; n--)
        *to++ = *from++;
    glide_lines_stage(lines, pass, in, out, lines->constants + lines->longs);
    lines->longs += bytes / 4;
}

static void set_points(struct glide_points *to, const struct glide_part *part, int32 y)
{
    const struct plane *of = &part->iterations->planes.of[part->first];

    glide_part_at(part, -EDGE_BIAS, y, &to->start);
    to->across.s = (int32)of[GLIDE_S].dx;
    to->across.t = (int32)of[GLIDE_T].dx;
    to->across.w = (int32)of[GLIDE_W].dx;
    to->down.s = (int32)of[GLIDE_S].dy;
    to->down.t = (int32)of[GLIDE_T].dy;
    to->down.w = (int32)of[GLIDE_W].dy;
}

/* Whether all lines of the unit have the same passes, all of them in assembly. */
static int32 is_steady(struct glide_part *part)
{
    const struct glide_sampling *from = &part->samplings[part->band];
    const uint32 bits = part->bands->of[part->band].bits;

    if (!part->is_one || part->piece_bits
        || (part->glide->modes.dither && bits & (GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER)))
        return 0;
    if (!(bits & GLIDE_NEEDS_OWN))
        return 1;
    return (from->level || glide_sampling_find(part, part->band))
        && from->sample != glide_filter_line && from->sample != glide_filter_line_8;
}

static int32 has_coordinates(const struct glide_part *part, const struct glide_part *before)
{
    const struct glide_steps *a, *b;

    if (!before || !(before->bands->of[before->band].bits & GLIDE_NEEDS_OWN)
        || before->first != part->first || before->coordinates != part->coordinates)
        return 0;
    a = &part->samplings[part->band].steps;
    b = &before->samplings[before->band].steps;
    return a->shift == b->shift && a->half == b->half && a->last_s == b->last_s
        && a->last_t == b->last_t && a->behind == b->behind;
}

/* Adds the passes for a unit's factors, or makes these if they are the same for all pixels. */
static void add_factors(struct glide_lines *lines, const struct glide_part *part,
                        struct glide_factors *factors)
{
    const uint32 number = part->first == GLIDE_OWN;
    const struct glide_points *points = &lines->points[number];
    const struct glide_band *band = &part->bands->of[part->band];
    const struct glide_modes *modes = &part->glide->modes;
    const int32 varies = part->by_w && (points->across.w || points->down.w);
    uint16 *values = varies ? part->scratch->lods : &lines->lods[number];
    uint8 *details = varies ? part->scratch->details : (uint8 *)&lines->details[number];
    struct glide_iterators one = {0, 0, 1 << 30};
    struct glide_nearness nearness;
    struct glide_lods lods;

    glide_factors_open(factors, band);
    if (!(band->bits & (GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER)))
        return;
    glide_lods_open(part, &lods);
    if (varies)
        glide_lines_add(lines, glide_lod, &points->at, values, &lods, sizeof lods);
    else
        glide_lod(part->by_w ? &points->start : &one, values, &lods, 1);
    if (band->bits & GLIDE_FRACTIONS_DIFFER) {
        factors->fractions = (const uint8 *)values + 1;
        factors->fraction_step = varies ? (int32)sizeof *values : 0;
    }
    if (band->bits & GLIDE_DETAILS_DIFFER) {
        nearness.end = (int16)(modes->detail_bias * 256);
        nearness.shift = (uint16)(8 - modes->detail_scale);
        if (varies)
            glide_lines_add(lines, glide_details, values, details, &nearness, sizeof nearness);
        else
            glide_details(values, details, &nearness, 1);
        factors->details = details;
        factors->detail_step = varies;
    }
}

/* Adds the passes of a unit and of those upstream. to: null if it is the frame. */
static void add_part(struct glide_lines *lines, struct glide_part *part, uint32 *to)
{
    const struct glide_band *band = &part->bands->of[part->band];
    struct glide_part *before = band->bits & GLIDE_NEEDS_OTHER ? part->upstream : 0;
    struct glide_sampling *from = &part->samplings[part->band];
    struct glide_points *points = &lines->points[part->first == GLIDE_OWN];
    const struct plane *of = &part->iterations->planes.of[part->first];
    struct glide_line_scratch *work = part->scratch;
    struct glide_factors factors;
    struct glide_times times;

    if (band->bits & GLIDE_IS_OTHER) {
        add_part(lines, part->upstream, to);
        return;
    }
    if (before)
        add_part(lines, before, work->other);
    if (band->bits & GLIDE_NEEDS_OWN) {
        from->steps.s = (int32)of[GLIDE_S].dx;
        from->steps.t = (int32)of[GLIDE_T].dx;
        from->steps.w = (int32)of[GLIDE_W].dx;
        if (!has_coordinates(part, before))
            glide_lines_stage(lines, part->coordinates, &points->at, work->coordinates, &from->steps);
        if (glide_part_times(part, part->band, work->other, &times)) {
            glide_lines_add(lines, glide_bilinear_times, work->coordinates, to, &times, sizeof times);
            return;
        }
        glide_lines_stage(lines, from->sample, work->coordinates,
                          band->bits & GLIDE_IS_OWN ? to : work->texels, from->level);
    }
    if (band->bits & GLIDE_IS_OWN)
        return;
    add_factors(lines, part, &factors);
    glide_combine_add(lines, &band->combining, &part->glide->modes, &factors, work->texels,
                      before ? work->other : 0, to);
}

/* Makes the texels of the last pass 5/6/5 pixels. */
static void add_store(struct glide_lines *lines, uint32 *colours)
{
    struct glide_stage *last = &lines->stages[lines->last_stage - 1];

    if (last->out == colours && (last->pass == glide_bilinear || last->pass == glide_bilinear_times)) {
        last->pass = last->pass == glide_bilinear ? glide_bilinear_565 : glide_bilinear_times_565;
        last->out = 0;
    } else {
        glide_lines_stage(lines, glide_store_565, colours, 0, 0);
    }
}

int32 glide_lines_find(struct glide_lines *lines, struct glide_plan *plan, const struct setup *s)
{
    const int32 pixel_bytes = s->frame->pixel_bytes;
    uint32 *const colours = plan->scratch->colours;

    lines->last_points = lines->last_stage = 0;
    lines->longs = 0;
    lines->is_full = 0;
    for (struct glide_part *part = plan->parts; part; part = part->upstream) {
        const uint16 number = part->first == GLIDE_OWN;

        if (!is_steady(part))
            return 0;
        if (number > lines->last_points)
            lines->last_points = number;
        set_points(&lines->points[number], part, s->box.top);
    }
    add_part(lines, plan->parts, pixel_bytes == 4 ? 0 : colours);
    if (pixel_bytes == 2)
        add_store(lines, colours);
    lines->last_stage--;
    lines->lines = s->edges.lines;
    lines->count = s->box.bottom - s->box.top;
    lines->pitch = s->frame->pitch;
    lines->bits = pixel_bytes == 4 ? 2 : 1;
    lines->pixels = s->frame->pixels + s->box.top * s->frame->pitch - EDGE_BIAS * pixel_bytes;
    return !lines->is_full && lines->count > 0;
}
