#include "triangle/polygon.h"

#include "polygon/counts.h"
#include "polygon/shading.h"

/* Returns a value in 1/2^20, raised. */
static int32 triangle_value(fix16 value)
{
    return (int32)((uint32)(value + SNAPPED_RAISED) << 4);
}

/* Sets a vertex's place and, with a map, u and v. Returns 0 if it is out of range. */
static int32 triangle_vertex(struct snapped_vertex *to, const struct triangle_range *range,
                             fix16 scale, const struct vertex *from)
{
    const uint32 reach = (uint32)SNAPPED_TEXELS << 16;
    const int32 x = (from->x + SNAPPED_HALF) >> (16 - SNAPPED_BITS);
    const int32 y = (from->y + SNAPPED_HALF) >> (16 - SNAPPED_BITS);
    fix16 s = from->s, t = from->t;

    if ((uint32)x > range->right || (uint32)y > range->bottom)
        return 0;
    to->x = (int16)(x + SNAPPED_ONE);
    to->y = (int16)(y + SNAPPED_ONE - 1);
    if (!scale)
        return 1;
    if (scale != 65536) {
        s = mul_round(s, scale);
        t = mul_round(t, scale);
    }
    to->u = triangle_value(s);
    to->v = triangle_value(t);
    return (uint32)s + reach < 2 * reach && (uint32)t + reach < 2 * reach;
}

/* Returns non-zero if vertices cover fewer than SNAPPED_LINES lines. */
static int32 triangle_is_low(const struct snapped_vertex *v, int32 count)
{
    int32 top = v->y, low = top;

    while (--count > 0) {
        v++;
        top = v->y < top ? v->y : top;
        low = v->y > low ? v->y : low;
    }
    return low - top < SNAPPED_LINES * SNAPPED_ONE;
}

int32 triangle_vertices(struct snapped_vertex *to, const struct vertex *from, int32 count,
                        const struct frame *frame, const struct material *material)
{
    const int32 is_shaded = material->mapper == MAPPER_GOURAUD;
    const int32 is_lit = material->light != 0;
    const fix16 scale = material->map ? material->map->scale : 0;
    struct triangle_range range;
    int32 all = 1;

    triangle_range_set(&range, frame);
    for (; count > 0; count--, to++, from++) {
        fix16 low = from->shade, high = low;

        if (!triangle_vertex(to, &range, scale, from)) {
            to->x = -1;
            all = 0;
        } else if (is_shaded) {
            shade_limits(&low, &high);
            to->u = triangle_value(shade_limited(from->shade, low, high));
        } else if (is_lit) {
            const fix16 level = SHADE_LEVEL(from->shade);

            low = high = level;
            shade_limits(&low, &high);
            to->level = shade_limited(level, low, high) << 4;
        }
    }
    return all;
}

/* Returns non-zero if u or v may be the same along lines: the triangles of the polygon have a level edge,
   are not small, and a level edge has equal ends. Triangles have the same picture in either way of
   drawing only if they are not small. */
static int32 triangle_may_be_still(const struct snapped_vertex *v, int32 count)
{
    const struct snapped_vertex *last = &v[count - 1];
    const int32 y = v->y;
    int32 other = y, still = 0;

    for (; count > 0; count--, last = v++) {
        if (v->y != y) {
            if (other != y && v->y != other)
                return 0;
            other = v->y;
        }
        still |= v->y == last->y && (v->u == last->u || v->v == last->v);
    }
    return still && (other - y > SMALL_HEIGHT || y - other > SMALL_HEIGHT);
}

static int32 triangle_is_equal(const struct vertex *v, int32 count, int32 lowest)
{
    const fix16 first = v->shade >> lowest;

    while (--count > 0)
        if ((++v)->shade >> lowest != first)
            return 0;
    return 1;
}

/* Returns a cheaper kind that the vertices allow; sets *colour if that is flat. */
static enum span_kind triangle_by_vertices(enum span_kind kind, uint32 *colour,
                                           const struct renderer *renderer,
                                           const struct polygon *polygon,
                                           const struct material *material)
{
    const struct vertex *const v = polygon->vertices;
    const int32 level = v->shade >> LEVEL_BITS;

    if (kind == SPAN_TRIANGLES_GOURAUD && RULE_IS_ON(renderer, EQUAL_SHADES)
        && triangle_is_equal(v, polygon->count, 16)) {
        *colour = (uint32)v->shade >> 16;
        return SPAN_TRIANGLES_FLAT;
    }
    if (kind == SPAN_LIT_GOURAUD && RULE_IS_ON(renderer, EQUAL_LEVELS)
        && triangle_is_equal(v, polygon->count, LEVEL_BITS))
        kind = SPAN_LIT_WRAP;   /* u is as without wraps of v */
    if (kind != SPAN_LIT && kind != SPAN_LIT_WRAP)
        return kind;
    if (level == 0 && material->light->dark && RULE_IS_ON(renderer, NO_LIGHT)) {
        *colour = *material->light->texels;
        return SPAN_TRIANGLES_FLAT;
    }
    if (level == LIGHT_LEVELS - 1 && material->light->full && RULE_IS_ON(renderer, FULL_LIGHT))
        return kind == SPAN_LIT ? SPAN_AFFINE_ADDX : SPAN_AFFINE_ADDX_WRAP;
    return kind;
}

/* MAPPER_ARBITRARY: returns non-zero if no pixel of a triangle leaves the map. */
static int32 triangle_stays_in_map(const struct snapped_vertex *v, const struct map *map)
{
    const int32 dx1 = v[1].x - v->x, dy1 = v[1].y - v->y, dx2 = v[2].x - v->x, dy2 = v[2].y - v->y;
    const int32 area = dx1 * dy2 - dx2 * dy1;
    const int32 low = (SNAPPED_RAISED + BELOW_MAP) << 4, over = (SNAPPED_RAISED - ABOVE_MAP) * 16;
    const int32 u_high = (map->width << 20) + over, v_high = (map->height << 20) + over;
    int32 most = dy1 > dy2 ? dy1 : dy2, least = dy1 < dy2 ? dy1 : dy2;

    most = most < 0 ? 0 : most;
    least = least > 0 ? 0 : least;
    for (int32 i = 0; i < 3; i++, v++)
        if (v->u < low || v->u > u_high || v->v < low || v->v > v_high)
            return 0;
    return (area < 0 ? -area : area) >= SLIVER_MAP * (most - least);
}

enum span_kind triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                                const struct material *material)
{
    enum span_kind kind = triangle_kind(renderer->frame, material);
    const int32 count = polygon->count;
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX];
    struct triangle list[TRIANGLE_CORNERS_MAX - 2];
    struct triangle_plan plan;
    struct triangle_lines lines;
    triangle_drawer *routine;
    uint32 colour = material->colour;
    int32 i;

    if (kind == SPAN_KINDS || count > TRIANGLE_CORNERS_MAX
        || !triangle_vertices(vertices, polygon->vertices, count, renderer->frame, material)
        || !triangle_is_low(vertices, count))
        return SPAN_KINDS;
    if (material->mapper == MAPPER_ARBITRARY
        && (count > 3 || !triangle_stays_in_map(vertices, material->map)))
        return SPAN_KINDS;
    if (material->mapper != MAPPER_FLAT && kind != SPAN_TRIANGLES_AFFINE)
        kind = triangle_by_vertices(kind, &colour, renderer, polygon, material);
    else if (kind == SPAN_TRIANGLES_AFFINE && triangle_may_be_still(vertices, count))
        kind = SPAN_AFFINE_ADDX;
    for (i = 2; i < count; i++) {
        list[i - 2].a = vertices;
        list[i - 2].b = &vertices[i - 1];
        list[i - 2].c = &vertices[i];
    }
    routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
    plan.colour = colour * 0x01010101;
    plan.list = list;
    plan.end = &list[count - 2];
    if (routine == triangles_spans) {
        routine(&plan);
        return plan.lowered;
    }
    if (!renderer->counts || !renderer->only_counts)
        routine(&plan);
    return kind;
}
