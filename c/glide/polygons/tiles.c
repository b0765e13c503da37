/* Decides if a polygon is drawn from tiles, and finds them. */
#include "glide/polygons/tiles.h"

enum { SIDE = MAP_PAGE_SIDE, SHIFT_LEAST = 14, SHIFT_MOST = 18 };

/* Returns the shift from 14.18 to the finest steps that any used unit distinguishes: coordinates if
   it filters, texels if it samples points. */
static int32 find_shift(const struct glide_tiling *tiling)
{
    const struct glide_lod *lod = tiling->lods;
    int32 shift = SHIFT_MOST;

    for (const struct glide_part *part = tiling->plan->parts; part; part = part->upstream, lod++) {
        const int32 bits = lod->filter == GLIDE_BILINEAR ? part->glide->modes.fraction_bits : 0;
        const int32 own = SHIFT_MOST + lod->level - bits;

        if (part->bits & GLIDE_NEEDS_OWN && own < shift)
            shift = own;
    }
    return shift;
}

/* Returns non-zero if a plane's change along a line, and along a column, has 31 bits at most. */
static int32 is_short(const struct plane *plane, const struct rectangle *box)
{
    return fix_magnitude((int32)plane->dx) <= 0x7fffffffu / (uint32)(box->right - box->left)
        && fix_magnitude((int32)plane->dy) <= 0x7fffffffu / (uint32)(box->bottom - box->top);
}

/* Finds each unit's LOD; returns 0 if one changes from pixel to pixel or has separate points. */
static int32 find_lods(struct glide_tiling *tiling, const struct glide_plan *plan,
                       const struct glide_iterations *iterations)
{
    struct glide_lod *lod = tiling->lods;
    struct glide_point point;

    point.w = 1 << 30;
    point.lod = iterations->points[0].lod;
    point.x = point.y = 0;
    for (const struct glide_part *part = plan->parts; part; part = part->upstream, lod++) {
        if (part->first != GLIDE_S)
            return 0;
        if (glide_only_lod(part->glide, lod))
            continue;
        if (part->glide->modes.dither)
            return 0;
        glide_find_lod(part->glide, &point, lod);
    }
    return 1;
}

/* Returns non-zero if all units have the same s and t, none divides, and each has one LOD. */
static int32 is_map(struct glide_tiling *tiling, const struct glide_plan *plan,
                    const struct glide_iterations *iterations, const struct rectangle *box)
{
    return !iterations->divided[0] && is_short(&iterations->planes.of[GLIDE_S], box)
        && is_short(&iterations->planes.of[GLIDE_T], box) && find_lods(tiling, plan, iterations);
}

/* clamped: how many of the units clamp. */
static int32 kind_of(int32 units, int32 clamped)
{
    return !clamped ? GLIDE_TILING_WRAPPED
        : clamped == units ? GLIDE_TILING_CLAMPED : GLIDE_TILING_ENDLESS;
}

static void find_kinds(struct glide_tiling *tiling)
{
    int32 units = 0, s = 0, t = 0;

    for (const struct glide_part *part = tiling->plan->parts; part; part = part->upstream) {
        if (!(part->bits & GLIDE_NEEDS_OWN))
            continue;
        units++;
        s += part->glide->modes.clamp_s;
        t += part->glide->modes.clamp_t;
    }
    tiling->s.kind = kind_of(units, s);
    tiling->t.kind = kind_of(units, t);
}

/* Returns the range of the vertices' values (16.16) and finds the least; both are 14.18. */
static uint32 vertices_range(const struct setup *s, const fix16 *value, int32 *least)
{
    fix16 low;
    const fix16 range = vertex_range(value, s->count, &low);

    *least = (int32)((uint32)low << 2);
    return (uint32)range << 2;
}

/* Returns the range of a plane within the polygon's box and finds the least, if that is smaller
   than range; else returns range. */
static uint32 box_range(const struct setup *s, const struct planes *planes, int32 which,
                        uint32 range, int32 *least)
{
    const struct plane *plane = &planes->of[which];
    const int32 across = (int32)plane->dx * (s->box.right - s->box.left - 1);
    const int32 down = (int32)plane->dy * (s->box.bottom - s->box.top - 1);
    const uint32 inside = fix_magnitude(across) + fix_magnitude(down);

    if (inside >= range)
        return range;
    *least = (int32)(planes_at(planes, which, s->box.left, s->box.top)
                     + (uint32)(across < 0 ? across : 0) + (uint32)(down < 0 ? down : 0));
    return inside;
}

static void all_of(struct glide_tiling_axis *axis)
{
    axis->low = 0;
    axis->high = SIDE - 1;
}

static void find_axis(struct glide_tiling *tiling, struct glide_tiling_axis *axis, int32 least,
                      uint32 range)
{
    const int32 bits = tiling->shift + GLIDE_TILE_BITS;
    const uint32 end = ((uint32)least & ((1u << bits) - 1)) + range;

    axis->first = least >> bits;
    axis->tiles = (int32)(end >> bits) + 1;
    axis->low = least >> tiling->shift & (SIDE - 1);
    axis->high = (int32)(end >> tiling->shift & (SIDE - 1));
    if (axis->kind == GLIDE_TILING_WRAPPED && axis->tiles >= tiling->period) {
        if (axis->tiles > tiling->period)
            all_of(axis);
        axis->first = 0;
        axis->tiles = tiling->period;
    } else if (axis->kind == GLIDE_TILING_CLAMPED) {
        const int32 first = glide_tile_held(axis->first, tiling->period);
        const int32 last = glide_tile_held(axis->first + axis->tiles - 1, tiling->period);

        if (first != axis->first || last != axis->first + axis->tiles - 1)
            all_of(axis);
        axis->first = first;
        axis->tiles = last - first + 1;
    }
}

static void find_axes(struct glide_tiling *tiling, const struct planes *planes,
                      const struct setup *s)
{
    uint32 range;
    int32 least;

    range = vertices_range(s, &s->given->s, &least);
    range = box_range(s, planes, GLIDE_S, range, &least);
    find_axis(tiling, &tiling->s, least, range);
    range = vertices_range(s, &s->given->t, &least);
    range = box_range(s, planes, GLIDE_T, range, &least);
    find_axis(tiling, &tiling->t, least, range);
}

/* Returns how many rows must be paid for so that the tile's paid rows include low to high without a
   gap. */
static uint32 missing(const struct glide_tile *tile, int32 low, int32 high)
{
    if (!tile || tile->low > tile->high)
        return (uint32)(high + 1 - low);
    return (uint32)((low < tile->low ? tile->low - low : 0)
                    + (high > tile->high ? high - tile->high : 0));
}

/* Finds the rows that the polygon may show of its tiles in the row-th row of tiles. */
static void rows_of(const struct glide_tiling_axis *t, int32 row, int32 *low, int32 *high)
{
    *low = row ? 0 : t->low;
    *high = row < t->tiles - 1 ? SIDE - 1 : t->high;
}

/* Returns how many pixels must be paid for. With `claims` it takes memory for all tiles instead and
   marks their rows as paid for; it then returns 0, or 1 if there is too little memory. */
static uint32 visit(const struct glide_tiling *tiling, int32 claims)
{
    const struct glide_tiling_axis *s = &tiling->s, *t = &tiling->t;
    uint32 rows = 0;

    for (int32 j = 0; j < t->tiles; j++) {
        const int32 row = glide_tile_number(tiling, t, t->first + j);
        int32 low, high;

        rows_of(t, j, &low, &high);
        for (int32 i = 0; i < s->tiles; i++) {
            const int32 column = glide_tile_number(tiling, s, s->first + i);
            struct glide_tile *tile = glide_tile_find(tiling, column, row);

            if (claims) {
                if (!tile)
                    tile = glide_tile_take(tiling, column, row);
                if (!tile)
                    return 1;
                tile->low = low < tile->low ? low : tile->low;
                tile->high = high > tile->high ? high : tile->high;
                continue;
            }
            if (tile)
                tile->used = tiling->now;
            rows += missing(tile, low, high);
        }
    }
    return rows * SIDE;
}

/* Returns non-zero if the pixels drawn directly are enough to buy those needed. Otherwise the
   polygon is drawn directly too, and its pixels are added to them. */
static int32 is_bought(struct glide_tiling *tiling, uint32 needed, const struct setup *s)
{
    const uint32 own = lines_pixels(s->edges.lines, s->box.bottom - s->box.top);
    uint32 *direct = &tiling->set->direct;

    if (*direct + own < needed || visit(tiling, 1)) {
        *direct += own;
        return 0;
    }
    *direct = *direct > needed ? *direct - needed : 0;
    return 1;
}

int32 glide_tiles_pay(struct glide_tiling *tiling, struct glide_pipe *pipe, struct glide_plan *plan,
                      struct glide_iterations *iterations, const struct setup *s)
{
    const int32 room = glide_tiles_room(pipe, s->frame->pixel_bytes);
    const struct plane *planes = iterations->planes.of;
    uint32 needed;

    if (!room || !is_map(tiling, plan, iterations, &s->box))
        return 0;
    tiling->pipe = pipe;
    tiling->plan = plan;
    tiling->iterations = iterations;
    tiling->pixel_bytes = s->frame->pixel_bytes;
    tiling->shift = find_shift(tiling);
    if (tiling->shift < SHIFT_LEAST)
        return 0;
    tiling->period = 1 << (SHIFT_MOST - tiling->shift);
    find_kinds(tiling);
    find_axes(tiling, &iterations->planes, s);
    if (tiling->s.tiles > room || tiling->t.tiles > room
        || tiling->s.tiles * tiling->t.tiles > room)
        return 0;
    tiling->now = ++pipe->tiles->now;
    tiling->set = glide_tile_set_find(tiling);
    needed = visit(tiling, 0);
    if (needed && (s->renderer->only_counts || !is_bought(tiling, needed, s)))
        return 0;
    tiling->draw = tiling->pixel_bytes == 2 ? glide_tile_16 : glide_tile_32;
    tiling->s.size = tiling->t.size = 0;
    tiling->makes = 0;
    tiling->s.step = tiling->paging.s = (int32)planes[GLIDE_S].dx;
    tiling->t.step = tiling->paging.t = (int32)planes[GLIDE_T].dx;
    tiling->paging.left = (uint16)(24 - tiling->shift);
    tiling->made.points[0].lod = iterations->points[0].lod;
    return 1;
}
