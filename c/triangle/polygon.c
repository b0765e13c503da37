#include "triangle/polygon.h"

#include "math/math.h"
#include "polygon/shading.h"

#define TEXEL_REACH ((uint32)SNAPPED_TEXELS << 16)

int32 triangle_may(const struct renderer *renderer, const struct polygon *polygon,
                   const struct material *material)
{
    /* The range of Gouraud's shades is a triangle's own. */
    const int32 most = material->mapper == MAPPER_GOURAUD ? 3 : TRIANGLE_CORNERS_MAX;

    return renderer->snapped_reciprocals && polygon->count <= most
        && triangle_routine(renderer->frame, material);
}

/* Returns a coordinate in 1/16 pixel, rounded to the nearest. */
static int32 snapped(fix16 coordinate)
{
    return (coordinate + (1 << (15 - SNAPPED_BITS))) >> (16 - SNAPPED_BITS);
}

/* Returns a value in 1/2^20, raised. */
static int32 raised(fix16 value)
{
    return (int32)((uint32)(value + SNAPPED_RAISED) << 4);
}

/* Converts the vertices of a polygon. Returns 0 if one is out of range, or the polygon too high. */
static int32 convert(struct snapped_vertex *to, const struct polygon *polygon,
                     const struct material *material, const struct frame *frame)
{
    const struct vertex *from = polygon->vertices;
    const uint32 width = (uint32)frame->width * SNAPPED_ONE;
    const uint32 right = width < SNAPPED_WIDTH * SNAPPED_ONE ? width : SNAPPED_WIDTH * SNAPPED_ONE;
    const uint32 bottom = (uint32)frame->height * SNAPPED_ONE;
    const fix16 scale = material->map ? material->map->scale : 65536;
    int32 top = FRAME_SIDE_MAX * SNAPPED_ONE, low = 0;
    fix16 shade_low = 0, shade_high = 0;

    if (material->mapper == MAPPER_GOURAUD)
        shade_range(from, polygon->count, &shade_low, &shade_high);
    for (int32 i = polygon->count; i > 0; i--, from++, to++) {
        const int32 x = snapped(from->x), y = snapped(from->y);

        if ((uint32)x > right || (uint32)y > bottom)
            return 0;
        top = y < top ? y : top;
        low = y > low ? y : low;
        to->x = (int16)(x + SNAPPED_ONE);
        to->y = (int16)(y + SNAPPED_ONE - 1);
        if (material->mapper == MAPPER_GOURAUD) {
            to->u = raised(shade_limited(from->shade, shade_low, shade_high));
        } else if (material->map) {
            const fix16 u = scale == 65536 ? from->s : mul_round(from->s, scale);
            const fix16 v = scale == 65536 ? from->t : mul_round(from->t, scale);

            if ((uint32)u + TEXEL_REACH >= 2 * TEXEL_REACH
                || (uint32)v + TEXEL_REACH >= 2 * TEXEL_REACH)
                return 0;
            to->u = raised(u);
            to->v = raised(v);
        }
    }
    return low - top < SNAPPED_LINES * SNAPPED_ONE;
}

int32 triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                       const struct material *material, int32 draws)
{
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX];
    struct triangle list[TRIANGLE_CORNERS_MAX - 2];
    struct triangle_plan plan;
    int32 i;

    if (!convert(vertices, polygon, material, renderer->frame))
        return 0;
    if (!draws)
        return 1;
    for (i = 2; i < polygon->count; i++) {
        list[i - 2].a = vertices;
        list[i - 2].b = &vertices[i - 1];
        list[i - 2].c = &vertices[i];
    }
    triangle_plan_set(&plan, renderer, material);
    plan.list = list;
    plan.end = &list[polygon->count - 2];
    triangle_routine(renderer->frame, material)(&plan);
    return 1;
}
