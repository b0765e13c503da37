/* Finds where along a line a unit's pixels leave a band.

   A pixel's LOD is the polygon's + bias + dither + 30 * 256 - 256 log2 |w|, the logarithm rounded
   to the nearest. So it reaches a band if |w| is below the first number whose logarithm is too
   large. */
#include "glide/polygons/plan.h"

#define LOGARITHM_MOST (31 * GLIDE_LOD_ONE)   /* of |w| */

/* Returns the first number whose 256 log2, rounded, is `value` or more. If there is none, returns a
   number above any |w|. */
static uint32 first_with(int32 value)
{
    const uint32 before = (uint32)value - 1;

    if (value <= 0)
        return 1;
    if (value > LOGARITHM_MOST)
        return 0xffffffff;
    return (glide_logarithms[before & 255] >> (31 - (before >> 8))) + 1;
}

/* Returns the bands' limits with dither / 16 added to LODs. */
static const uint32 *limits_of(struct glide_part *part, int32 dither)
{
    uint32 *limits = part->limits[dither];

    if (part->ready >> dither & 1)
        return limits;
    limits[0] = 0xffffffff;
    for (uint32 n = 1; n < part->bands->count; n++)
        limits[n] = first_with(part->lod + dither * (GLIDE_LOD_ONE / 16) + 30 * GLIDE_LOD_ONE + 1
                               - part->bands->of[n].lod.value);
    part->ready |= (uint32)1 << dither;
    return limits;
}

/* Returns how many pixels from w on have w's sign and |w| from low to high - 1, `left` at most. */
static int32 pixels_between(int32 w, int32 step, uint32 low, uint32 high, int32 left)
{
    const uint32 size = fix_magnitude(w), by = fix_magnitude(step);
    const uint32 end = w < 0 ? 0x80000001 : 0x80000000;
    uint32 count;

    if (!step)
        return left;
    if (high > end)
        high = end;
    count = ((w < 0) == (step < 0) ? high - 1 - size : size - low) / by + 1;
    return count < (uint32)left ? (int32)count : left;
}

/* Limits of |w|: low included, high excluded. */
struct limits {
    uint32 low, high;
};

/* Returns the band of pixels with |w| = size, and its limits. */
static uint32 band_of(struct glide_part *part, int32 dither, uint32 size, struct limits *between)
{
    const uint32 *limits = limits_of(part, dither);
    const uint32 last = part->bands->count - 1;
    uint32 n = 0;

    while (n < last && size < limits[n + 1])
        n++;
    between->low = n < last ? limits[n + 1] : 0;
    between->high = limits[n];
    return n;
}

uint32 glide_runs_band(struct glide_part *part, int32 dither, int32 size)
{
    struct limits between;

    return part->bands->count == 1 ? 0 : band_of(part, dither, (uint32)size, &between);
}

/* Finds the band of the first of `left` pixels; returns how many pixels from there on are in it. */
static int32 pixels_of_band(struct glide_part *part, int32 dither, int32 w, int32 step, int32 left,
                            uint32 *band)
{
    struct limits between;

    *band = band_of(part, dither, part->by_w ? fix_magnitude(w) : (uint32)1 << 30, &between);
    if (!part->by_w) {
        between.low = 0;
        between.high = 0xffffffff;
    }
    return pixels_between(w, step, between.low, between.high, left);
}

void glide_runs_open(struct glide_runs *runs, struct glide_part *part, const struct glide_row *row,
                     int32 first, int32 count)
{
    const struct plane *of = &part->iterations->planes.of[part->first];
    const uint32 bits = row->step_bits;

    runs->part = part;
    glide_part_at(part, row->x + (first << bits), row->y, &runs->at);
    runs->by.s = (int32)(of[GLIDE_S].dx << bits);
    runs->by.t = (int32)(of[GLIDE_T].dx << bits);
    runs->by.w = (int32)(of[GLIDE_W].dx << bits);
    runs->dither = part->glide->modes.dither ? glide_dither(row->x, row->y) / (GLIDE_LOD_ONE / 16) : 0;
    runs->left = count;
    runs->end = first + count;
    runs->line = row->count;
    runs->count = 0;
    runs->band = part->band;
}

static void step(int32 *at, int32 by, int32 count)
{
    *at = (int32)((uint32)*at + (uint32)by * (uint32)count);
}

void glide_runs_find(struct glide_runs *runs)
{
    if (runs->count) {
        step(&runs->at.s, runs->by.s, runs->count);
        step(&runs->at.t, runs->by.t, runs->count);
        step(&runs->at.w, runs->by.w, runs->count);
    }
    runs->count = pixels_of_band(runs->part, runs->dither, runs->at.w, runs->by.w, runs->left,
                                 &runs->band);
}

/* Like glide_runs_alike for one unit, by the line's least and greatest dither; sets *mixed only to
   1. */
static int32 part_alike(struct glide_part *part, int32 x, int32 y, int32 count, int32 *mixed)
{
    const int32 w = (int32)planes_at(&part->iterations->planes, part->first + GLIDE_W, x, y);
    const int32 step = (int32)part->iterations->planes.of[part->first + GLIDE_W].dx;
    int32 least = GLIDE_DITHERS - 1, most = 0, other;
    uint32 near, far;

    for (int32 i = 0; i < 4; i++) {
        const int32 dither = glide_dither(i, y) / (GLIDE_LOD_ONE / 16);

        least = dither < least ? dither : least;
        most = dither > most ? dither : most;
    }
    count = pixels_of_band(part, least, w, step, count, &near);
    other = pixels_of_band(part, most, w, step, count, &far);
    *mixed |= near != far;
    return other < count ? other : count;
}

/* The same for all units, up to the first change in any of them. */
static int32 plan_alike(struct glide_plan *plan, int32 x, int32 y, int32 count, int32 *mixed)
{
    *mixed = 0;
    for (struct glide_part *part = plan->parts; part; part = part->upstream)
        if (part->glide->modes.dither)
            count = part_alike(part, x, y, count, mixed);
    return count;
}

int32 glide_runs_alike(struct glide_plan *plan, int32 x, int32 y, int32 count, int32 *mixed)
{
    int32 found = plan_alike(plan, x, y, count, mixed), next;

    while (found < count) {
        const int32 more = plan_alike(plan, x + found, y, count - found, &next);

        if (next != *mixed)
            break;
        found += more;
    }
    return found;
}
