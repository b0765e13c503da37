#include "n64/polygons/lower.h"

#include "drawing/fan.h"
#include "drawing/lower.h"
#include "polygon/counts.h"

static int32 shades_are_equal(const struct setup *s, const uint32 *colours)
{
    for (int32 i = 1; i < s->count; i++)
        if (colours ? colours[i] != colours[0] : s->given[i].shade != s->given->shade)
            return 0;
    return 1;
}

static void first_shade(struct n64_colour *shade, const struct setup *s, const uint32 *colours)
{
    uint32 grey = (uint32)s->given->shade >> 16;
    uint32 colour = colours ? *colours : grey << 24 | grey << 16 | grey << 8 | 255;

    shade->r = (int16)(colour >> 24);
    shade->g = (int16)(colour >> 16 & 255);
    shade->b = (int16)(colour >> 8 & 255);
    shade->a = (int16)(colour & 255);
}

void n64_lower_inputs(struct n64_needs *needs, struct setup *s, const struct n64 *n64,
                      const uint32 *colours)
{
    needs->inputs = n64->inputs;
    needs->divided = n64->modes.perspective;
    needs->shade.r = needs->shade.g = needs->shade.b = needs->shade.a = 0;
    if (needs->inputs & N64_INPUT_SHADE)        /* otherwise no page and no plan depends on it */
        first_shade(&needs->shade, s, colours);
    if (needs->inputs & N64_INPUT_SHADE && RULE_IS_ON(s, EQUAL_SHADES)
        && shades_are_equal(s, colours)) {
        RULE_APPLIES(s, EQUAL_SHADES);
        needs->inputs &= ~(uint32)N64_INPUT_SHADE;
    }
    if (needs->divided && needs->inputs & ~(uint32)N64_INPUT_SHADE && RULE_IS_ON(s, CONSTANT_W)
        && lower_w_is_constant(s)) {
        RULE_APPLIES(s, CONSTANT_W);
        needs->divided = 0;
    }
}

/* Returns non-zero if no pixel's s and t leave the range of the vertices, as far as they must not: they are on a
   plane, whatever the polygon says of itself. */
static int32 keeps_windows(const struct setup *s, const struct page_window *columns, const struct page_window *rows)
{
    return s->count == 3 || (columns->period && rows->period)
        || polygon_planar(s->scratch, s->given, s->given, s->count, PLANAR_TEXELS) == PLANAR_TEXELS;
}

/* Returns non-zero if the polygon can be drawn from a page: point sampling of one tile without
   levels, combined with constants, or copy mode into 16-bit pixels. */
static int32 is_plain(const struct n64_needs *needs, const struct setup *s, struct n64_unit *unit)
{
    struct page_window *const columns = &unit->columns, *const rows = &unit->rows;
    const struct n64 *n64 = &unit->n64;
    const struct n64_tile *tile = &n64->tiles[n64->primitive_tile];
    int32 copy = n64->modes.cycle == N64_COPY;

    return (copy ? s->frame->pixel_bytes == 2
                 : needs->inputs == N64_INPUT_TEXEL0 && !n64->modes.lod && !n64->modes.quad)
        && !needs->divided
        && n64_page_windows(tile, copy, columns, rows)
        && page_is_within(&s->given->s, s->count, columns) && page_is_within(&s->given->t, s->count, rows)
        && keeps_windows(s, columns, rows);
}

int32 n64_lower_to_plain(const struct n64_needs *needs, struct setup *s, struct n64_unit *unit,
                         const struct vertex **vertices)
{
    struct page_rows shown;

    unit->paged = 0;
    if (!RULE_IS_ON(s, N64_PLAIN) || !is_plain(needs, s, unit))
        return 0;
    RULE_APPLIES(s, N64_PLAIN);
    *vertices = page_vertices(s->scratch->paged, s->given, s->count, &unit->columns, &unit->rows, &shown);
    if (!n64_page_make(unit, needs, s->frame->pixel_bytes, &shown, s->scratch->room))
        return 0;
    page_material(&unit->page, s->material);
    if (unit->n64.inputs == N64_INPUT_TEXEL0)
        unit->paged = n64_unit_state(unit);
    return 1;
}

int32 n64_page_again(struct n64_unit *unit, struct renderer *renderer, const struct vertex *given)
{
    struct vertex *const vertices = renderer->scratch->paged;
    const struct page *page = &unit->page;
    struct page_rows shown;

    if ((unit->n64.modes.perspective && (given->w != given[1].w || given->w != given[2].w))
        || !page_is_within(&given->s, 3, &unit->columns) || !page_is_within(&given->t, 3, &unit->rows))
        return -1;
    page_vertices(vertices, given, 3, &unit->columns, &unit->rows, &shown);
    if (shown.first < page->from || shown.last >= page->end)
        return -1;
    return (int32)page_again(&unit->page, renderer, vertices);
}
