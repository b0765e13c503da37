#include "polygon/material.h"

#include "polygon/math.h"

/* What u and v may be off from the vertices' range at a pixel's centre: edges are
   within EDGE_ERROR pixels, times STEEP texels a pixel; 1,024 steps round by 1/2^17
   each in both directions; the plane itself by less than 1/2^10. */
#define INSET (65536 / 16)
#define STEEP (4 * 65536)

/* The least and the greatest value of an interpolant, as an offset in struct vertex. */
static void range(const fix16 *value, int32 count, fix16 *low, fix16 *high)
{
    *low = *high = *value;
    for (; count > 0; count--, value += sizeof(struct vertex) / sizeof(fix16)) {
        if (*value < *low)
            *low = *value;
        if (*value > *high)
            *high = *value;
    }
}

/* The shades between which every pixel has one of the vertices' range. */
static void shade_range(const struct vertex *vertices, int32 count, fix16 *low, fix16 *high)
{
    range(&vertices->shade, count, low, high);
    *low = (*low & ~0xffff) + INSET;
    *high = (*high | 0xffff) - INSET;
}

const struct vertex *material_vertices(const struct vertex *from, int32 count,
                                       const struct material *material)
{
    static struct vertex to[POLYGON_VERTICES_MAX];
    fix16 scale = material->map ? material->map->scale : 65536;
    fix16 low = 0, high = 0;

    if (material->mapper == MAPPER_GOURAUD)
        shade_range(from, count, &low, &high);
    else if (material->edges != EDGES_INTEGER && scale == 65536)
        return from;
    for (int32 i = 0; i < count; i++) {
        to[i] = from[i];
        if (material->edges == EDGES_INTEGER) {
            to[i].x &= ~0xffff;
            to[i].y &= ~0xffff;
        }
        if (material->mapper == MAPPER_GOURAUD) {
            to[i].s = from[i].shade < low ? low : from[i].shade > high ? high : from[i].shade;
            to[i].t = 0;
        } else if (scale != 65536) {
            to[i].s = mul_fix(from[i].s, scale);
            to[i].t = mul_fix(from[i].t, scale);
        }
    }
    return to;
}

/* Whether an edge's error may lead further out than INSET. */
static int32 is_steep(const struct material *material, const struct span_plan *span)
{
    return material->gradients != GRADIENTS_PLANE || span->dudx >= STEEP
        || span->dudx <= -STEEP || span->dvdx >= STEEP || span->dvdx <= -STEEP;
}

int32 material_range(struct hold_plan *hold, const struct material *material,
                     const struct vertex *vertices, int32 count,
                     const struct span_plan *span)
{
    fix16 s_low, s_high, t_low, t_high;
    int32 steep;

    if (material->mapper != MAPPER_GOURAUD && material->mapper != MAPPER_ARBITRARY)
        return 0;
    steep = is_steep(material, span);
    if (material->mapper == MAPPER_GOURAUD) {
        range(&vertices->s, count, &s_low, &s_high);
        hold->u_low = s_low & ~0xffff;
        hold->u_high = s_high | 0xffff;
        hold->v_low = hold->v_high = 0;
        return steep;
    }
    hold->u_low = hold->v_low = 0;
    hold->u_high = (material->map->width << 16) - 1;
    hold->v_high = (material->map->height << 16) - 1;
    range(&vertices->s, count, &s_low, &s_high);
    range(&vertices->t, count, &t_low, &t_high);
    return steep || s_low < INSET || s_high > hold->u_high - INSET
        || t_low < INSET || t_high > hold->v_high - INSET;
}
