/* Finds the cheapest way to draw a polygon with the same picture. */
#include "drawing/lower.h"
#include "glide/polygons/plan.h"
#include "polygon/counts.h"

enum { SIDE = MAP_PAGE_SIDE };

/* bits: a texel is 2^bits pixels of the page wide. */
static void find_window(uint32 texels, uint32 bits, struct page_window *window)
{
    window->origin = 0;
    window->least = PAGE_LEAST_ROW;     /* for columns too: they repeat */
    window->period = (fix16)(texels << bits << 16);
}

/* Returns non-zero if no texel is clamped: values stay margin texels inside the window. */
static int32 is_inside(const fix16 *value, int32 count, const struct page_window *window, int32 margin)
{
    const fix16 low = margin * 65536, high = window->period - low;

    for (; count > 0; count--) {
        if (*value < low || *value >= high)
            return 0;
        value += VERTEX_FIELDS;
    }
    return 1;
}

/* The unit's level that a page shows, and how. */
struct showing {
    const struct glide *glide;
    struct page *page;
    const struct glide_only *only;
    struct page_window columns, rows;
    uint32 bits;                /* a texel is 2^bits pixels wide */
};

static uint32 pixel_of(const struct showing *m, uint32 i, uint32 j, int32 pixel_bytes)
{
    const uint32 texel = glide_texel(m->glide, &m->only->level, i, j);

    return glide_frame_pixel(glide_combine_pixel(m->glide, &m->only->lod, texel, 0), pixel_bytes);
}

/* Both axes repeat within the page. */
static void make_row_16(uint16 *row, const struct showing *m, uint32 v)
{
    const uint32 wide = 1u << m->bits, period = m->only->level.columns << m->bits;

    for (uint32 u = 0; u < SIDE; u += wide) {
        const uint16 pixel = u < period ? (uint16)pixel_of(m, u >> m->bits, v, 2) : row[u - period];

        for (uint32 k = u; k < u + wide; k++)
            row[k] = pixel;
    }
}

static void make_row_32(uint32 *row, const struct showing *m, uint32 v)
{
    const uint32 wide = 1u << m->bits, period = m->only->level.columns << m->bits;

    for (uint32 u = 0; u < SIDE; u += wide) {
        const uint32 pixel = u < period ? pixel_of(m, u >> m->bits, v, 4) : row[u - period];

        for (uint32 k = u; k < u + wide; k++)
            row[k] = pixel;
    }
}

/* Returns a row that equals row v and is made, or end. */
static int32 find_same(const struct showing *m, int32 v, int32 from, int32 end)
{
    const int32 period = (int32)m->only->level.rows << m->bits;
    const int32 beside = v < from ? v + 1 : v - 1, far = v < from ? v + period : v - period;

    if (from == end)
        return end;
    return beside >> m->bits == v >> m->bits ? beside
        : far >= from && far < end ? far : end;
}

static void make_row(void *context, int32 v, int32 from, int32 end)
{
    const struct showing *m = context;
    const int32 bytes = m->page->map.texel_bytes, same = find_same(m, v, from, end);
    const uint32 j = (uint32)v >> m->bits & (m->only->level.rows - 1);
    uint32 *row = (uint32 *)page_row(m->page, v);

    if (same != end) {
        const uint32 *other = (const uint32 *)page_row(m->page, same);

        for (int32 k = 0; k < SIDE * bytes / 4; k++)
            row[k] = other[k];
    } else if (bytes == 2) {
        make_row_16((uint16 *)row, m, j);
    } else {
        make_row_32(row, m, j);
    }
}

/* Returns 0 if there is no memory for the rows. */
static int32 find_page(struct glide_pipe *pipe, struct showing *shown, int32 pixel_bytes,
                       const struct page_rows *rows)
{
    uint32 key[4];

    key[0] = (uint32)pixel_bytes;
    key[1] = shown->glide->mode_generation;
    key[2] = shown->glide->memory_generation;
    key[3] = shown->glide->table_generation;
    shown->page = &pipe->page;
    if (page_has(&pipe->page, key, 4, rows))
        return 1;
    if (!page_ready(&pipe->page, pixel_bytes, pipe->memory, rows))
        return 0;
    page_grow(&pipe->page, rows, make_row, shown);
    return 1;
}

/* Finds the unit's only LOD, if it has one, and its level; these are kept until its modes change. */
static void find_only(struct glide_pipe *pipe, struct showing *to)
{
    struct glide_only *only = &pipe->only;
    const struct glide *glide = pipe->chain.units[0];

    to->glide = glide;
    to->only = only;
    if (only->modes == glide->mode_generation + 1)
        return;
    only->modes = glide->mode_generation + 1;
    only->is_one = glide_only_lod(glide, &only->lod);
    glide_find_level(&glide->modes, only->lod.level, &only->level);
}

/* Finds how a page shows the unit's level; returns 0 if texels would be clamped. */
static int32 find_showing(const struct vertex *v, int32 count, uint32 bits, int32 margin, struct showing *to)
{
    const struct glide_modes *modes = &to->glide->modes;

    to->bits = bits;
    find_window(to->only->level.columns, bits, &to->columns);
    find_window(to->only->level.rows, bits, &to->rows);
    return (!modes->clamp_s || is_inside(&v->s, count, &to->columns, margin))
        && (!modes->clamp_t || is_inside(&v->t, count, &to->rows, margin));
}

/* Returns non-zero if the polygon needs only point samples of one unit's only level, unclamped. */
static int32 is_plain(const struct setup *s, struct glide_pipe *pipe, struct showing *to)
{
    if (pipe->chain.count > 1)
        return 0;
    find_only(pipe, to);
    return to->only->is_one && to->only->lod.filter == GLIDE_POINT
        && find_showing(s->given, s->count, to->only->lod.level, PAGE_MARGIN, to);
}

/* Returns the vertices with s and t in texels of a level. */
static const struct vertex *scale_vertices(const struct setup *s, uint32 level)
{
    struct vertex *scaled = (struct vertex *)s->scratch->room;

    for (int32 i = 0; i < s->count; i++) {
        scaled[i] = s->given[i];
        scaled[i].s >>= level;
        scaled[i].t >>= level;
    }
    return scaled;
}

static int32 draws_page(const struct setup *s, struct glide_pipe *pipe, struct showing *shown,
                        const struct page_rows *rows)
{
    if (!find_page(pipe, shown, s->frame->pixel_bytes, rows))
        return 0;
    page_material(&pipe->page, s->material);
    return 1;
}

/* Adds a row on either side: dithering moves points by less than a row beyond page_vertices'
   rows. */
static void add_rows(struct page_rows *rows)
{
    if (--rows->first < PAGE_LEAST_ROW || ++rows->last >= PAGE_LEAST_ROW + SIDE) {
        rows->first = PAGE_LEAST_ROW;
        rows->last = PAGE_LEAST_ROW + SIDE - 1;
    }
}

static int32 lower_to_dithered(struct setup *s, struct glide_pipe *pipe, const struct vertex **vertices)
{
    const struct glide *glide = pipe->chain.units[0];
    const struct vertex *given = s->given;
    struct showing shown;
    struct page_rows rows;
    int32 draws;

    find_only(pipe, &shown);
    if (pipe->chain.count > 1 || !shown.only->is_one
        || shown.only->lod.filter != GLIDE_BILINEAR
        || (glide->modes.perspective && !(given->w > 0 && lower_w_is_constant(s))))
        return 0;
    s->given = scale_vertices(s, shown.only->lod.level);
    draws = find_showing(s->given, s->count, 0, GLIDE_DITHERED_MARGIN, &shown);
    if (draws) {
        *vertices = page_vertices(s->scratch->paged, s->given, s->count, &shown.columns, &shown.rows, &rows);
        add_rows(&rows);
        draws = draws_page(s, pipe, &shown, &rows);
        pipe->page.plain.mapper = MAPPER_DITHERED;
    }
    s->given = given;
    return draws;
}

int32 glide_lower_to_plain(struct setup *s, struct glide_pipe *pipe, const struct vertex **vertices)
{
    const struct glide_modes *modes = &pipe->chain.units[0]->modes;
    struct page_rows rows;
    struct showing shown;

    if (pipe->adds)
        return 0;
    if (modes->dithered && lower_to_dithered(s, pipe, vertices))
        return 1;
    if (modes->perspective) {
        if (s->given->w <= 0 || !RULE_IS_ON(s, CONSTANT_W) || !lower_w_is_constant(s))
            return 0;
        RULE_APPLIES(s, CONSTANT_W);
    }
    if (!RULE_IS_ON(s, GLIDE_PLAIN) || !is_plain(s, pipe, &shown))
        return 0;
    RULE_APPLIES(s, GLIDE_PLAIN);
    *vertices = page_vertices(s->scratch->paged, s->given, s->count, &shown.columns, &shown.rows, &rows);
    if (!draws_page(s, pipe, &shown, &rows))
        return 0;
    pipe->paged = glide_state(shown.glide);
    return 1;
}

int32 glide_page_again(struct glide_pipe *pipe, struct renderer *renderer, const struct vertex *given)
{
    struct vertex *const vertices = renderer->scratch->paged;
    const struct page *page = &pipe->page;
    struct page_rows rows;
    struct showing shown;

    shown.glide = pipe->chain.units[0];
    shown.only = &pipe->only;
    if ((shown.glide->modes.perspective && (given->w <= 0 || given->w != given[1].w || given->w != given[2].w))
        || !find_showing(given, 3, shown.only->lod.level, PAGE_MARGIN, &shown))
        return -1;
    page_vertices(vertices, given, 3, &shown.columns, &shown.rows, &rows);
    if (rows.first < page->from || rows.last >= page->end)
        return -1;
    return (int32)page_again(&pipe->page, renderer, vertices);
}
