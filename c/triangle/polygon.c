#include "triangle/polygon.h"

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
    const int32 x = (from->x + (1 << (15 - SNAPPED_BITS))) >> (16 - SNAPPED_BITS);
    const int32 y = (from->y + (1 << (15 - SNAPPED_BITS))) >> (16 - SNAPPED_BITS);
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

/* Converts the vertices of a polygon. Returns 0 if one is out of range, or the polygon too high. */
static int32 convert(struct snapped_vertex *to, const struct polygon *polygon,
                     const struct material *material, const struct frame *frame)
{
    const struct vertex *from = polygon->vertices;
    const fix16 scale = material->map ? material->map->scale : 0;
    struct triangle_range range;
    fix16 low, high;

    triangle_range_set(&range, frame);
    for (int32 i = 0; i < polygon->count; i++)
        if (!triangle_vertex(&to[i], &range, scale, &from[i]))
            return 0;
    if (material->mapper == MAPPER_GOURAUD) {
        shade_range(from, polygon->count, &low, &high);
        for (int32 i = 0; i < polygon->count; i++)
            to[i].u = triangle_value(shade_limited(from[i].shade, low, high));
    }
    return triangle_is_low(to, polygon->count);
}

int32 triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                       const struct material *material)
{
    triangle_drawer *const routine = triangle_routine(renderer->frame, material);
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX];
    struct triangle list[TRIANGLE_CORNERS_MAX - 2];
    struct triangle_plan plan;
    int32 i;

    if (!routine || polygon->count > triangle_corners(material)
        || !convert(vertices, polygon, material, renderer->frame))
        return 0;
    if (renderer->counts && renderer->only_counts)
        return 1;
    for (i = 2; i < polygon->count; i++) {
        list[i - 2].a = vertices;
        list[i - 2].b = &vertices[i - 1];
        list[i - 2].c = &vertices[i];
    }
    triangle_plan_set(&plan, renderer, material);
    plan.list = list;
    plan.end = &list[polygon->count - 2];
    routine(&plan);
    return 1;
}
