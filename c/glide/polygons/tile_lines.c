/* Draws lines from tiles, whose rows are made when they are first shown. */
#include "glide/polygons/tiles.h"

enum { SIDE = MAP_PAGE_SIDE };

/* Finds the passes for rows of tiles: lines with a step of a 256th of a tile a pixel. */
static int32 find_making(struct glide_tiling *tiling)
{
    struct glide_iterations *made = &tiling->made;
    struct plane *of = made->planes.of;

    if (tiling->makes)
        return 1;
    made->planes.i = made->planes.j = 0;
    made->divided[0] = 0;
    for (int32 n = GLIDE_S; n <= GLIDE_W; n++)
        of[n].dx = of[n].dy = 0;
    of[GLIDE_S].dx = of[GLIDE_T].dy = 1u << tiling->shift;
    of[GLIDE_W].at = 1u << 30;
    tiling->making.scratch = tiling->plan->scratch;
    tiling->makes = glide_plan_find(&tiling->making, tiling->pipe, made, tiling->pixel_bytes);
    return tiling->makes;
}

/* Makes row v of a tile; returns 0 if there is no memory. */
static int32 make_row(struct glide_tiling *tiling, struct glide_tile *tile, int32 v)
{
    struct plane *of = tiling->made.planes.of;
    struct frame row;

    row.pixels = glide_tile_row(tile, v, tiling->pixel_bytes);
    row.width = SIDE;
    row.height = 1;
    row.pitch = SIDE * tiling->pixel_bytes;
    row.pixel_bytes = tiling->pixel_bytes;
    of[GLIDE_S].at = (uint32)tile->s << (tiling->shift + GLIDE_TILE_BITS);
    of[GLIDE_T].at = ((uint32)tile->t << GLIDE_TILE_BITS | (uint32)v) << tiling->shift;
    return glide_plan_draw(&tiling->making, &row, 0, 0, SIDE);
}

/* Makes rows low to high of a tile; returns 0 if there is no memory. */
static int32 make_rows(struct glide_tiling *tiling, struct glide_tile *tile, int32 low, int32 high)
{
    if (tile->from < tile->end && low >= tile->from && high < tile->end)
        return 1;
    if (!find_making(tiling))
        return 0;
    if (tile->from == tile->end)
        tile->from = tile->end = low;
    for (; tile->from > low; tile->from--)
        if (!make_row(tiling, tile, tile->from - 1))
            return 0;
    for (; tile->end <= high; tile->end++)
        if (!make_row(tiling, tile, tile->end))
            return 0;
    return 1;
}

/* Returns non-zero if a tile is a whole period: lines need not be cut at its edges. */
static int32 repeats(const struct glide_tiling *tiling, const struct glide_tiling_axis *axis)
{
    return tiling->period == 1 && axis->kind == GLIDE_TILING_WRAPPED;
}

/* Sets the made part of a tile, where lines are drawn without a search for tiles. at: a point on
   it. */
static void open_window(struct glide_tiling *tiling, const struct glide_tile *tile,
                        const struct glide_iterators *at)
{
    const int32 bits = tiling->shift + GLIDE_TILE_BITS;
    const uint32 tiles = ~0u << bits;

    tiling->s.origin = (uint32)at->s & tiles;
    tiling->s.size = repeats(tiling, &tiling->s) ? ~0u : 1u << bits;
    tiling->t.origin = ((uint32)at->t & tiles) + ((uint32)tile->from << tiling->shift);
    tiling->t.size = (uint32)(tile->end - tile->from) << tiling->shift;
    if (repeats(tiling, &tiling->t) && tile->end - tile->from == SIDE)
        tiling->t.size = ~0u;
    tiling->paging.pixels = glide_tile_row(tile, 0, tiling->pixel_bytes);
}

static int32 leaves(const struct glide_tiling *tiling, int32 from, int32 to)
{
    return (from ^ to) >> (tiling->shift + GLIDE_TILE_BITS) != 0;
}

/* Returns how many of count pixels from `at` on are on one tile. */
static int32 reach(const struct glide_tiling *tiling, const struct glide_tiling_axis *axis, int32 at,
                   int32 count)
{
    const uint32 last = (1u << (tiling->shift + GLIDE_TILE_BITS)) - 1;
    const uint32 inside = (uint32)at & last;

    if (repeats(tiling, axis)
        || !leaves(tiling, at, (int32)((uint32)at + (uint32)(axis->step * (count - 1)))))
        return count;
    return axis->step > 0 ? (int32)((last - inside) / (uint32)axis->step) + 1
        : (int32)(inside / (uint32)-axis->step) + 1;
}

/* Makes the rows for count pixels on one tile; returns 0 if there is no tile for them. */
static int32 prepare(struct glide_tiling *tiling, const struct glide_iterators *at, int32 count)
{
    const int32 bits = tiling->shift + GLIDE_TILE_BITS;
    const int32 end = (int32)((uint32)at->t + (uint32)(tiling->t.step * (count - 1)));
    const int32 s = glide_tile_number(tiling, &tiling->s, at->s >> bits);
    const int32 t = glide_tile_number(tiling, &tiling->t, at->t >> bits);
    int32 low = at->t >> tiling->shift & (SIDE - 1), high = end >> tiling->shift & (SIDE - 1);
    struct glide_tile *tile = glide_tile_find(tiling, s, t);

    if (tiling->t.step < 0) {
        const int32 other = low;

        low = high;
        high = other;
    }
    if (leaves(tiling, at->t, end)) {
        low = 0;
        high = SIDE - 1;
    }
    if (!tile)
        tile = glide_tile_take(tiling, s, t);
    if (!tile || !make_rows(tiling, tile, low, high))
        return 0;
    open_window(tiling, tile, at);
    return 1;
}

/* Draws pixels without tiles; returns how many were drawn one by one. */
static int32 draw_untiled(const struct glide_tiling *tiling, const struct frame *frame, int32 x,
                          int32 y, int32 count)
{
    if (glide_plan_draw(tiling->plan, frame, x, y, count))
        return 0;
    glide_pixels_draw(tiling->pipe, tiling->iterations, frame, x, x + count, y);
    return count;
}

/* Draws a line tile by tile; returns how many pixels were drawn one by one. */
static int32 draw_line(struct glide_tiling *tiling, const struct frame *frame,
                      struct glide_iterators *at, int32 x, int32 y, int32 count)
{
    uint8 *pixels = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    int32 missed = 0;

    for (;;) {
        const int32 piece = reach(tiling, &tiling->t, at->t,
                                  reach(tiling, &tiling->s, at->s, count));

        if (prepare(tiling, at, piece))
            tiling->draw(at, pixels, &tiling->paging, piece);
        else
            missed += draw_untiled(tiling, frame, x, y, piece);
        count -= piece;
        if (!count)
            return missed;
        x += piece;
        pixels += piece * frame->pixel_bytes;
        at->s = (int32)((uint32)at->s + (uint32)(tiling->s.step * piece));
        at->t = (int32)((uint32)at->t + (uint32)(tiling->t.step * piece));
    }
}

/* Returns non-zero if both ends of a line are on the made part of the tile last used. A line
   changes by less than 2^31. */
static int32 is_on(const struct glide_tiling_axis *axis, int32 at, int32 steps)
{
    const uint32 from = (uint32)at - axis->origin;

    return from < axis->size && from + (uint32)(axis->step * steps) < axis->size;
}

uint32 glide_tiles_draw(struct glide_tiling *tiling, const struct setup *s)
{
    const struct planes *planes = &tiling->iterations->planes;
    const struct plane *of = planes->of;
    const struct frame *frame = s->frame;
    const struct scanline *line = s->edges.lines;
    uint32 left_s = planes_at(planes, GLIDE_S, 0, s->box.top);
    uint32 left_t = planes_at(planes, GLIDE_T, 0, s->box.top);
    uint8 *row = frame->pixels + s->box.top * frame->pitch;
    uint32 missed = 0;

    for (int32 y = s->box.top; y < s->box.bottom; y++, line++) {
        const int32 x = line->left - EDGE_BIAS, last = line->last - line->left;
        struct glide_iterators at;

        at.s = (int32)(left_s + (uint32)x * of[GLIDE_S].dx);
        at.t = (int32)(left_t + (uint32)x * of[GLIDE_T].dx);
        at.w = 0;
        if (last >= 0 && is_on(&tiling->s, at.s, last) && is_on(&tiling->t, at.t, last))
            tiling->draw(&at, row + x * frame->pixel_bytes, &tiling->paging, last + 1);
        else if (last >= 0)
            missed += (uint32)draw_line(tiling, frame, &at, x, y, last + 1);
        left_s += of[GLIDE_S].dy;
        left_t += of[GLIDE_T].dy;
        row += frame->pitch;
    }
    return missed;
}
