#include "tx/lower.h"

#include "polygon/counts.h"
#include "polygon/lower.h"
#include "polygon/page.h"
#include "tx/page.h"

static int32 shades_are_equal(const struct setup *s, const uint32 *colours)
{
    for (int32 i = 1; i < s->count; i++)
        if (colours ? colours[i] != colours[0] : s->given[i].shade != s->given->shade)
            return 0;
    return 1;
}

static void first_shade(struct tx_colour *shade, const struct setup *s, const uint32 *colours)
{
    uint32 grey = (uint32)s->given->shade >> 16;
    uint32 colour = colours ? *colours : grey << 24 | grey << 16 | grey << 8 | 255;

    shade->r = (int16)(colour >> 24);
    shade->g = (int16)(colour >> 16 & 255);
    shade->b = (int16)(colour >> 8 & 255);
    shade->a = (int16)(colour & 255);
}

void tx_lower_inputs(struct tx_needs *needs, struct setup *s, const struct tx *tx,
                     const uint32 *colours)
{
    needs->inputs = tx->inputs;
    needs->divided = tx->modes.perspective;
    first_shade(&needs->shade, s, colours);
    if (needs->inputs & TX_INPUT_SHADE
        && APPLIES(EQUAL_SHADES, shades_are_equal(s, colours)))
        needs->inputs &= ~(uint32)TX_INPUT_SHADE;
    if (needs->divided && needs->inputs & ~(uint32)TX_INPUT_SHADE
        && APPLIES(CONSTANT_W, lower_w_is_constant(s)))
        needs->divided = 0;
}

int32 tx_lower_to_flat(const struct tx_needs *needs, struct setup *s)
{
    return APPLIES(TX_FLAT, !needs->inputs);
}

/* As the shared rules of pages have it. */
static void to_page(const struct tx_axis *axis, const struct tx_window *from,
                    struct page_window *to)
{
    to->origin = (axis->low << 14) + from->first * 65536;
    to->period = from->period * 65536;
    to->least = from->least;
}

static int32 find_windows(const struct tx_tile *tile, int32 copy, struct page_window *columns,
                          struct page_window *rows)
{
    struct tx_window s, t;

    if (!tx_page_windows(tile, copy, &s, &t))
        return 0;
    to_page(&tile->s, &s, columns);
    to_page(&tile->t, &t, rows);
    return 1;
}

/* Point sampling of one tile without levels, the rest constants. */
static int32 is_plain(const struct tx_needs *needs, const struct setup *s, const struct tx *tx,
                      struct page_window *columns, struct page_window *rows)
{
    const struct tx_tile *tile = &tx->tiles[tx->primitive_tile];
    int32 copy = tx->modes.cycle == TX_COPY;

    return (copy ? s->frame->pixel_bytes == 2
                 : needs->inputs == TX_INPUT_TEXEL0 && !tx->modes.lod && !tx->modes.quad)
        && !needs->divided
        && find_windows(tile, copy, columns, rows)
        && page_is_within(s, &s->given->s, columns) && page_is_within(s, &s->given->t, rows);
}

static fix16 extent(const fix16 *value, int32 count, fix16 *least)
{
    fix16 most = *value;

    *least = *value;
    for (int32 i = 1; i < count; i++) {
        value += sizeof(struct vertex) / sizeof *value;
        *least = *value < *least ? *value : *least;
        most = *value > most ? *value : most;
    }
    return most - *least;
}

static int32 is_parallelogram(const struct vertex *v)
{
    return v[0].x + v[2].x == v[1].x + v[3].x && v[0].y + v[2].y == v[1].y + v[3].y
        && v[0].t + v[2].t == v[1].t + v[3].t;
}

/* Whether t of each pixel is less than a texel beyond the vertices': it is one plane over all of
   them, and changes by 32 texels a pixel at most where edges are off by 1/64 of one. The area is
   in 1/256 pixel, from corners in 1/16. */
static int32 keeps_range(const struct setup *s, fix16 range)
{
    const struct vertex *v = s->given;
    fix16 least, width, height;
    int32 side, area;

    if (s->count > 4 || (s->count == 4 && !is_parallelogram(v)))
        return 0;
    width = extent(&v->x, s->count, &least);
    height = extent(&v->y, s->count, &least);
    side = ((width > height ? width : height) >> 16) + 1;
    if (width < 0 || height < 0 || side > 1024)
        return 0;
    area = ((v[1].x - v[0].x) >> 12) * ((v[2].y - v[0].y) >> 12)
        - ((v[2].x - v[0].x) >> 12) * ((v[1].y - v[0].y) >> 12);
    return (area < 0 ? -area : area) >= 16 * side * ((range >> 16) + 5);
}

/* Rows of the page that a polygon shows; all of them where they are not known. */
static void find_rows(const struct setup *s, fix16 t_origin, int32 least_row, int32 *first,
                      int32 *last)
{
    fix16 least, range = extent(&s->given->t, s->count, &least);

    *first = ((least - t_origin) >> 16) - PAGE_MARGIN;
    *last = ((least + range - t_origin) >> 16) + PAGE_MARGIN;
    if (*first < least_row || *last >= least_row + MAP_PAGE_SIDE || !keeps_range(s, range)) {
        *first = least_row;
        *last = least_row + MAP_PAGE_SIDE - 1;
    }
}

int32 tx_lower_to_plain(const struct tx_needs *needs, struct setup *s, struct tx_unit *unit,
                        struct material *plain, const struct vertex **vertices)
{
    struct page_window columns, rows;
    fix16 s_origin, t_origin;
    int32 first, last;

    if (!APPLIES(TX_PLAIN, is_plain(needs, s, &unit->tx, &columns, &rows)))
        return 0;
    s_origin = page_origin(s, &s->given->s, &columns);
    t_origin = page_origin(s, &s->given->t, &rows);
    find_rows(s, t_origin, rows.least, &first, &last);
    if (!tx_page_make(unit, needs, s->frame->pixel_bytes, first, last))
        return 0;
    page_material(plain, s->material, &unit->page.map);
    *vertices = page_vertices(s, s_origin, t_origin);
    return 1;
}
