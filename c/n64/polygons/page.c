/* A tile as the plain mappers read it: a page of 256x256 combined pixels in the frame's format.
   Only rows that polygons need are made. */
#include "n64/polygons/plan.h"

enum { SIDE = MAP_PAGE_SIDE };

static int32 period(const struct n64_axis *axis)
{
    int32 bits = axis->mask > 10 ? 10 : axis->mask;

    return 1 << (bits + (axis->mirror ? 1 : 0));
}

/* Returns non-zero if an axis repeats. Copy mode does not clamp; without a mask the axis then
   continues beyond the tile's edges. */
static int32 repeats(const struct n64_axis *axis, int32 copy)
{
    return axis->mask && (copy || !axis->clamp);
}

static int32 last_index(const struct n64_axis *axis)
{
    return (axis->high >> 2) - (axis->low >> 2);
}

/* An axis that does not repeat has its texels in the middle of the page. No page can show it if
   its low edge has a larger fraction than its high edge: it clamps in the middle of a texel. */
static int32 find_window(const struct n64_axis *axis, int32 copy, struct page_window *window)
{
    const int32 last = last_index(axis);

    if (axis->shift)
        return 0;
    window->origin = axis->low << 14;
    window->period = 0;
    if (repeats(axis, copy)) {
        window->period = period(axis) * 65536;
        return window->period <= SIDE * 65536;
    }
    window->origin += (((last + 1 - SIDE) >> 1) - window->least) * 65536;
    return axis->high >= axis->low && last < SIDE
        && (copy || (axis->low & 3) <= (axis->high & 3));
}

int32 n64_page_windows(const struct n64_tile *tile, int32 copy, struct page_window *columns,
                       struct page_window *rows)
{
    columns->least = 0;
    rows->least = PAGE_LEAST_ROW;
    return find_window(&tile->s, copy, columns) && find_window(&tile->t, copy, rows);
}

/* Data for making a page's rows. */
struct making {
    uint32 *room;
    struct n64_unit *unit;
    const struct n64_needs *needs;
    const struct n64_axis *s, *t;
    struct page_window columns, rows;
    int32 from, count;          /* columns to draw; the others repeat these or the edges */
    struct frame frame;         /* the page, row 0; rows 128 on precede it, as in MAP_PAGE */
    struct n64_planes planes;
    struct n64_plan *plan;      /* or null */
};

/* Returns the coordinate of column or row k: s10.5. */
static int32 coordinate(const struct page_window *window, int32 k)
{
    return (int16)((window->origin >> 11) + k * 32);
}

/* Returns the relative index of column or row 0. */
static int32 first_index(const struct n64_axis *axis, const struct page_window *window)
{
    return (window->origin >> 16) - (axis->low >> 2);
}

/* Returns non-zero if the page shows the axis' first and last texel beyond its edges. */
static int32 clamps(const struct making *m, const struct page_window *window)
{
    return !window->period && m->unit->n64.modes.cycle != N64_COPY
        && coordinate(window, window->least + SIDE - 1) >= 0;
}

static void find_columns(struct making *m)
{
    int32 least = 128 / m->frame.pixel_bytes;   /* n64_copy_row's least */

    m->from = 0;
    m->count = SIDE;
    if (m->columns.period) {
        m->count = m->columns.period >> 16 > least ? m->columns.period >> 16 : least;
    } else if (clamps(m, &m->columns)) {
        m->from = -first_index(m->s, &m->columns);
        m->count = last_index(m->s) + 1;
    }
}

/* One texel a pixel; draw_texels sets t for each row. */
static void find_planes(struct making *m)
{
    struct plane *of = m->planes.all.of;

    m->planes.all.i = m->planes.divided = m->planes.shaded = 0;
    of[N64_S].at = (uint32)coordinate(&m->columns, 0) << 16;
    of[N64_S].dx = 32u << 16;
    of[N64_W].at = N64_W_ONE;
    of[N64_S].dy = of[N64_T].dx = of[N64_T].dy = of[N64_W].dx = of[N64_W].dy = 0;
}

static void copy_texels(const struct making *m, uint16 *row, int32 t)
{
    const struct n64 *n64 = &m->unit->n64;
    uint32 texels[2];

    for (int32 u = m->from; u < m->from + m->count; u++) {
        n64_copy_texels(n64, n64->primitive_tile, coordinate(&m->columns, u), t, texels);
        row[u] = (uint16)(texels[0] >> 16);
    }
}

/* Returns non-zero if the four copies of each TLUT entry are equal: each of copy mode's four
   pixels reads another copy. */
static int32 copies_are_equal(const struct n64 *n64)
{
    const uint8 *entry = &n64->tmem[N64_TMEM_BYTES / 2];

    for (int32 i = 0; i < 256; i++, entry += 8)
        for (int32 k = 0; k < 6; k++)
            if (entry[k] != entry[k + 2])
                return 0;
    return 1;
}

/* Returns non-zero if copy mode's four pixels equal four pixels of a page. */
static int32 are_alike(const struct n64 *n64)
{
    return n64->modes.tlut ? copies_are_equal(n64)
                          : n64->tiles[n64->primitive_tile].size == N64_16;
}

static void draw_texels(struct making *m, int32 v, int32 t)
{
    m->planes.all.j = v;
    m->planes.all.of[N64_T].at = (uint32)t << 16;
    if (m->plan) {
        struct scanline line;

        line.left = (uint16)(m->from + EDGE_BIAS);
        line.last = (int16)(m->from + m->count - 1 + EDGE_BIAS);
        n64_plan_draw(m->plan, &m->frame, &line, v, 1, SIDE);
    } else
        n64_draw_line(&m->unit->n64, &m->planes, &m->needs->shade, &m->frame, m->from,
                      m->from + m->count, v);
}

/* Copies pixel from to pixels first to end - 1. */
static void fill(uint8 *row, int32 pixel_bytes, int32 first, int32 end, int32 from)
{
    const uint32 pixel = pixel_bytes == 4 ? ((uint32 *)row)[from] : ((uint16 *)row)[from];

    for (; first < end; first++)
        pixel_write(row, first, pixel_bytes, pixel);
}

static void make_row(struct making *m, int32 v)
{
    int32 t = coordinate(&m->rows, v), bytes = m->frame.pixel_bytes;
    int32 used = m->count * bytes;
    uint8 *row = page_row(&m->unit->page, v);

    if (m->unit->n64.modes.cycle == N64_COPY)
        copy_texels(m, (uint16 *)row, t);
    else
        draw_texels(m, (int8)v, t);
    if (m->columns.period && m->count < SIDE)
        n64_copy_row((const uint32 *)row, (uint32 *)(row + used), (m->frame.pitch - used) / 4);
    fill(row, bytes, 0, m->from, m->from);
    if (!m->columns.period)
        fill(row, bytes, m->from + m->count, SIDE, m->from + m->count - 1);
}

/* Makes row v, by copying if an equal row is made already. */
static void find_row(void *context, int32 v, int32 from, int32 end)
{
    struct making *m = context;
    const struct page *page = &m->unit->page;
    const int32 first = first_index(m->t, &m->rows);
    int32 same = end;           /* none */

    if (m->rows.period)
        same = v < from ? v + (m->rows.period >> 16) : v - (m->rows.period >> 16);
    else if (clamps(m, &m->rows))
        same = v < -first ? v + 1 : v > last_index(m->t) - first ? v - 1 : end;
    if (same >= from && same < end)
        n64_copy_row((const uint32 *)page_row(page, same), (uint32 *)page_row(page, v),
                     m->frame.pitch / 4);
    else
        make_row(m, v);
}

static void make_rows(struct making *m, const struct page_rows *rows)
{
    struct page *page = &m->unit->page;
    const struct n64 *n64 = &m->unit->n64;
    int32 copy = n64->modes.cycle == N64_COPY;

    m->s = &n64->tiles[n64->primitive_tile].s;
    m->t = &n64->tiles[n64->primitive_tile].t;
    n64_page_windows(&n64->tiles[n64->primitive_tile], copy, &m->columns, &m->rows);
    m->frame.pixel_bytes = page->map.texel_bytes;
    m->frame.pitch = SIDE * m->frame.pixel_bytes;
    m->frame.pixels = (uint8 *)page->map.texels;
    find_columns(m);
    find_planes(m);
    m->plan = copy ? 0 : n64_plan_find(m->needs, m->unit, &m->planes, m->frame.pixel_bytes, m->room);
    page_grow(page, rows, find_row, m);
}

static uint32 packed(const uint8 *colour)
{
    return (uint32)colour[0] << 24 | (uint32)colour[1] << 16 | (uint32)colour[2] << 8 | colour[3];
}

static void find_key(uint32 *key, const struct n64 *n64, int32 n, int32 pixel_bytes,
                     const struct n64_colour *shade)
{
    key[0] = n64->tmem_generation;
    key[1] = n64->mode_generation;
    n64_tile_key_find(&key[2], &n64->tiles[n]);
    key[5] = packed(n64->primitive);
    key[6] = packed(n64->environment);
    key[7] = (uint32)n64->primitive_fraction << 8 | (uint32)pixel_bytes;
    key[8] = (uint32)shade->r << 16 | (uint32)shade->g;
    key[9] = (uint32)shade->b << 16 | (uint32)shade->a;
}

int32 n64_page_make(struct n64_unit *unit, const struct n64_needs *needs, int32 pixel_bytes,
                    const struct page_rows *rows, uint32 *room)
{
    struct page *page = &unit->page;
    struct making making;
    uint32 key[PAGE_KEY];

    find_key(key, &unit->n64, unit->n64.primitive_tile, pixel_bytes, &needs->shade);
    if (page_has(page, key, PAGE_KEY, rows))
        return 1;
    if (unit->n64.modes.cycle == N64_COPY && !are_alike(&unit->n64))
        return 0;
    if (!page_ready(page, pixel_bytes, unit->memory, rows))
        return 0;
    making.room = room;
    making.unit = unit;
    making.needs = needs;
    make_rows(&making, rows);
    return 1;
}
