#include "triangle/polygon.h"

#include "polygon/shading.h"

/* Converts the vertices of a polygon. Returns 0 if one is out of range, or the polygon too high. */
static int32 convert(struct snapped_vertex *to, const struct polygon *polygon,
                     const struct material *material, const struct frame *frame)
{
    const struct vertex *from = polygon->vertices;
    struct triangle_range range;
    fix16 low, high;

    triangle_range_set(&range, frame, material);
    for (int32 i = 0; i < polygon->count; i++)
        if (!triangle_vertex(&to[i], &range, from[i].x, from[i].y, from[i].s, from[i].t))
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
