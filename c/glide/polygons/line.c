/* Draws a line of a polygon: each unit run by run, each run pass by pass. */
#include "glide/polygons/plan.h"

void glide_lods_open(const struct glide_part *part, struct glide_lods *lods)
{
    const struct glide_modes *modes = &part->glide->modes;
    const int32 least = glide_lod_least(modes), most = glide_lod_most(modes);
    const int32 lod = part->lod - GLIDE_LOD_ONE;

    lods->w = part->by_w ? (int32)part->iterations->planes.of[part->first + GLIDE_W].dx : 0;
    lods->least = (int16)(least < most ? least : most);
    lods->most = (int16)most;
    lods->logarithms = part->logarithms;
    for (int32 i = 0; i < 4; i++)
        lods->lods[i] = (int16)(lod < -32000 ? -32000 : lod);
}

void glide_lods_set(const struct glide_part *part, const struct glide_row *row, int32 x,
                    struct glide_lods *lods)
{
    if (!part->glide->modes.dither)
        return;
    for (int32 i = 0; i < 4; i++) {
        const int32 lod = part->lod - GLIDE_LOD_ONE + glide_dither(x + (i << row->step_bits), row->y);

        lods->lods[i] = (int16)(lod < -32000 ? -32000 : lod);
    }
}

/* Finds LODs of a run's pixels. x: the first pixel's. */
static void find_lods(const struct glide_runs *runs, const struct glide_row *row, int32 x, int32 count)
{
    struct glide_iterators at;
    struct glide_lods lods;

    at.w = runs->part->by_w ? runs->at.w : 1 << 30;
    glide_lods_open(runs->part, &lods);
    lods.w = (int32)((uint32)lods.w << row->step_bits);
    glide_lods_set(runs->part, row, x, &lods);
    glide_lod(&at, runs->part->scratch->lods, &lods, count);
}

/* Finds a run's factors that depend on LODs. */
static void find_factors(struct glide_factors *factors, const struct glide_runs *runs,
                         const struct glide_row *row, int32 x)
{
    const struct glide_part *part = runs->part;
    struct glide_line_scratch *work = part->scratch;
    const struct glide_modes *modes = &part->glide->modes;
    const struct glide_band *band = &part->bands->of[runs->band];
    const int32 alike = (!part->by_w || !runs->by.w) && (!modes->dither || row->step_bits);
    const int32 count = alike ? 1 : runs->count;
    struct glide_nearness nearness;

    glide_factors_open(factors, band);
    if (!(band->bits & (GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER)))
        return;
    find_lods(runs, row, x, count);
    if (band->bits & GLIDE_FRACTIONS_DIFFER) {
        factors->fractions = (const uint8 *)work->lods + 1;
        factors->fraction_step = alike ? 0 : sizeof *work->lods;
    }
    if (band->bits & GLIDE_DETAILS_DIFFER) {
        nearness.end = (int16)(modes->detail_bias * 256);
        nearness.shift = (uint16)(8 - modes->detail_scale);
        glide_details(work->lods, work->details, &nearness, count);
        factors->details = work->details;
        factors->detail_step = !alike;
    }
}

/* Finds coordinates of a run that divides s and t only at the ends of pieces. */
static void find_pieces(const struct glide_runs *runs, struct glide_steps *steps)
{
    const uint32 place = (uint32)(runs->end - runs->left);
    const uint32 skip = place & ((1u << runs->part->piece_bits) - 1);
    struct glide_iterators at;

    at.s = (int32)((uint32)runs->at.s - skip * (uint32)runs->by.s);
    at.t = (int32)((uint32)runs->at.t - skip * (uint32)runs->by.t);
    at.w = (int32)((uint32)runs->at.w - skip * (uint32)runs->by.w);
    steps->s = runs->by.s;
    steps->t = runs->by.t;
    steps->w = runs->by.w;
    steps->skip = (uint16)skip;
    steps->left = runs->line - (int32)(place - skip);
    glide_pieces(&at, runs->part->scratch->coordinates, steps, runs->count);
}

static void find_coordinates(struct glide_runs *runs, struct glide_steps *steps)
{
    static const struct glide_iterators none = {0, 0, 0};
    const int32 is_none = runs->part->hides_behind && runs->at.w < 0;

    if (runs->part->piece_bits) {
        find_pieces(runs, steps);
        return;
    }
    steps->s = is_none ? 0 : runs->by.s;
    steps->t = is_none ? 0 : runs->by.t;
    steps->w = runs->by.w;
    runs->part->coordinates(is_none ? &none : &runs->at, runs->part->scratch->coordinates, steps,
                            runs->count);
}

/* Finds a run's coordinates and returns the passes to its texels; null if there are none. */
static const struct glide_sampling *find_sampling(struct glide_runs *runs)
{
    struct glide_sampling *from = &runs->part->samplings[runs->band];

    if (!from->level && !glide_sampling_find(runs->part, runs->band))
        return 0;
    find_coordinates(runs, &from->steps);
    return from;
}

int32 glide_part_times(const struct glide_part *part, uint32 band, const uint32 *other, struct glide_times *times)
{
    const struct glide_sampling *from = &part->samplings[band];

    if (!(part->bands->of[band].bits & GLIDE_IS_TIMES && part->products && from->sample == glide_bilinear))
        return 0;
    times->quads = from->level->quads;
    times->mask_s = from->level->mask_s;
    times->mask_t = from->level->mask_t;
    times->columns_bits = from->level->columns_bits;
    times->spare = 0;
    times->other = other;
    times->products = part->products;
    return 1;
}

/* Draws a run by one unit; returns 0 if it has no passes. x: the first pixel. other: the colours
   from upstream, or null if there are none or they are not used. */
static int32 draw_run(struct glide_runs *runs, const struct glide_row *row, int32 x,
                      const uint32 *other, uint32 *to)
{
    const struct glide_part *part = runs->part;
    struct glide_line_scratch *work = part->scratch;
    const struct glide_band *band = &part->bands->of[runs->band];
    const struct glide_sampling *from;
    struct glide_factors factors;
    struct glide_times times;

    if (band->bits & GLIDE_NEEDS_OWN) {
        from = find_sampling(runs);
        if (!from)
            return 0;
        if (glide_part_times(part, runs->band, other, &times)) {
            glide_bilinear_times(work->coordinates, to, &times, runs->count);
            return 1;
        }
        from->sample(work->coordinates, band->bits & GLIDE_IS_OWN ? to : work->texels, from->level,
                     runs->count);
    }
    if (!(band->bits & GLIDE_IS_OWN)) {
        find_factors(&factors, runs, row, x);
        glide_combine_line(&band->combining, &part->glide->modes, &factors, work->texels, other, to,
                           runs->count);
    }
    return 1;
}

/* Draws a row's pixels `first` to `first` + count - 1 by a unit and those upstream. Upstream
   colours are drawn for the whole row first if all runs need them, else run by run. */
static int32 draw_part(struct glide_part *part, const struct glide_row *row, int32 first, int32 count,
                       uint32 *to)
{
    struct glide_line_scratch *work = part->scratch;
    const struct glide_bands *bands = part->bands;
    const int32 before = part->upstream && part->every & GLIDE_NEEDS_OTHER
        && !(part->bits & GLIDE_IS_OTHER);
    struct glide_runs runs;

    if (before && !draw_part(part->upstream, row, first, count, work->other))
        return 0;
    glide_runs_open(&runs, part, row, first, count);
    for (int32 done = 0; glide_runs_next(&runs); done += runs.count) {
        const uint32 bits = part->upstream ? bands->of[runs.band].bits : 0;
        const uint32 *other = before ? work->other + done : 0;

        if (bits & GLIDE_IS_OTHER) {
            if (!draw_part(part->upstream, row, first + done, runs.count, to + done))
                return 0;
            continue;
        }
        if (bits & GLIDE_NEEDS_OTHER && !before) {
            if (!draw_part(part->upstream, row, first + done, runs.count, work->other))
                return 0;
            other = work->other;
        }
        if (!draw_run(&runs, row, row->x + ((first + done) << row->step_bits), other, to + done))
            return 0;
    }
    return 1;
}

/* Draws four lines of every fourth pixel, in each of which dithering is constant. */
static int32 draw_quarters(struct glide_plan *plan, struct glide_row *row, int32 count, uint32 *to)
{
    struct glide_line_scratch *work = plan->scratch;
    const int32 x = row->x;
    struct glide_quarters quarters;

    row->step_bits = 2;
    for (int32 i = 0; i < 4 && i < count; i++) {
        row->x = x + i;
        if (!draw_part(plan->parts, row, 0, (count - i + 3) >> 2, work->quarters[i]))
            return 0;
    }
    quarters.bytes = sizeof work->quarters[0];
    glide_interleave(work->quarters, to, &quarters, count);
    return 1;
}

/* Draws texels directly as pixels. Filtered 16-bit pixels need no separate store pass. */
static int32 draw_direct(struct glide_part *part, const struct glide_row *row, uint8 *pixels,
                         int32 pixel_bytes, int32 count)
{
    struct glide_line_scratch *work = part->scratch;
    const struct glide_sampling *from;
    struct glide_runs runs;

    glide_runs_open(&runs, part, row, 0, count);
    for (; glide_runs_next(&runs); pixels += runs.count * pixel_bytes) {
        from = find_sampling(&runs);
        if (!from)
            return 0;
        if (pixel_bytes == 4) {
            from->sample(work->coordinates, pixels, from->level, runs.count);
        } else if (from->sample == glide_bilinear) {
            glide_bilinear_565(work->coordinates, pixels, from->level, runs.count);
        } else {
            from->sample(work->coordinates, work->texels, from->level, runs.count);
            glide_store_565(work->texels, pixels, 0, runs.count);
        }
    }
    return 1;
}

static int32 draw_row(struct glide_plan *plan, struct glide_row *row, uint8 *pixels,
                      int32 pixel_bytes, int32 count, int32 mixed)
{
    uint32 *to = pixel_bytes == 4 ? (uint32 *)pixels : plan->scratch->colours;

    if (plan->is_direct && !mixed)
        return draw_direct(plan->parts, row, pixels, pixel_bytes, count);
    if (!(mixed ? draw_quarters(plan, row, count, to)
          : draw_part(plan->parts, row, 0, count, to)))
        return 0;
    if (pixel_bytes == 2)
        glide_store_565(to, pixels, 0, count);
    return 1;
}

int32 glide_plan_draw(struct glide_plan *plan, const struct frame *frame, int32 x, int32 y,
                      int32 count)
{
    const int32 bytes = frame->pixel_bytes;
    uint8 *pixels = frame->pixels + y * frame->pitch + x * bytes;
    struct glide_row row;

    row.x = x;
    row.y = y;
    row.count = count;
    row.step_bits = 0;
    if (plan->has_mips) {
        uint32 *to = bytes == 4 ? (uint32 *)pixels : plan->scratch->colours;

        if (glide_mips_draw(plan, &row, to, count)) {
            if (bytes == 2)
                glide_store_565(to, pixels, 0, count);
            return 1;
        }
    }
    for (int32 left = count; ; left -= count, row.x = x += count, pixels += count * bytes) {
        int32 mixed = 0;

        row.step_bits = 0;
        if (plan->is_dithered)
            count = glide_runs_alike(plan, x, y, left, &mixed);
        if (!draw_row(plan, &row, pixels, bytes, count, mixed))
            return 0;
        if (count == left)
            return 1;
    }
}

/* Finds all colours of the line first: if some have no passes, nothing is added yet, and the caller
   adds the whole line once. */
int32 glide_plan_add(struct glide_plan *plan, const struct frame *frame, int32 x, int32 y,
                     int32 count)
{
    struct glide_line_scratch *work = plan->scratch;
    uint8 *pixels = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    struct frame colours;
    struct glide_mix mix;

    colours.pixels = (uint8 *)work->colours;
    colours.width = frame->width;
    colours.height = frame->height;
    colours.pitch = 0;                  /* every line is the same memory */
    colours.pixel_bytes = 4;
    if (!glide_plan_draw(plan, &colours, x, y, count))
        return 0;
    mix.other = work->colours + x;
    mix.other_step = 4;
    if (frame->pixel_bytes == 4) {
        glide_add(pixels, pixels, &mix, count);
        return 1;
    }
    glide_widen_565(pixels, work->texels, 0, count);
    glide_add(work->texels, work->texels, &mix, count);
    glide_store_565(work->texels, pixels, 0, count);
    return 1;
}
