#include "drawing/material.h"

#include "math/math.h"
#include "polygon/shading.h"
#include "triangle/triangles.h"

/* INSET: how far u and v of a triangle may be outside the vertices' range at a pixel's centre. The
   parts: edges are within EDGE_ERROR pixels, half as much in a frame's 1,024 lines, times STEEP_4
   texels a pixel: 1/32; 512 steps are rounded by 1/2^17 each in both directions, and starts are
   raised by as much: 1/64; the plane itself is off by less than 1/2^10. ON_PLANE: only the edges
   count if the range is that of the stepped plane. */
#define INSET SHADE_INSET
#define ON_PLANE (3 * INSET / 4)
#define STEEP_4 (4 * 65536)

const struct vertex *material_vertices(struct vertex *to, const struct vertex *from, int32 count,
                                       const struct material *material)
{
    fix16 scale = material->map ? material->map->scale : 65536;
    fix16 low = 0, high = 0;

    if (material->mapper == MAPPER_GOURAUD)
        shade_range(from, count, &low, &high);
    else if (material->edges != EDGES_INTEGER && material->edges != EDGES_SNAPPED
             && scale == 65536)
        return from;
    for (int32 i = 0; i < count; i++) {
        to[i] = from[i];
        if (material->edges == EDGES_INTEGER) {
            to[i].x &= ~0xffff;
            to[i].y &= ~0xffff;
        } else if (material->edges == EDGES_SNAPPED) {
            to[i].x = (to[i].x + SNAPPED_HALF) & ~SNAPPED_MASK;
            to[i].y = (to[i].y + SNAPPED_HALF) & ~SNAPPED_MASK;
            low = high = from[i].shade;         /* its own range: polygons share vertices */
            shade_limits(&low, &high);
        }
        if (material->mapper == MAPPER_GOURAUD) {
            to[i].s = shade_limited(from[i].shade, low, high);
            to[i].t = 0;
        } else if (scale != 65536) {
            to[i].s = mul_round(from[i].s, scale);
            to[i].t = mul_round(from[i].t, scale);
        }
    }
    return to;
}

/* Returns non-zero if an edge's error may move u or v by more than INSET allows. */
static int32 is_steep(const struct material *material, const struct span_plan *span)
{
    return material->gradients != GRADIENTS_PLANE || span->dudx >= STEEP_4
        || span->dudx <= -STEEP_4 || span->dvdx >= STEEP_4 || span->dvdx <= -STEEP_4;
}

/* Finds the least and the greatest value of a coordinate's stepped plane at the vertices. Each
   value is the sum of three vertices' values times -1 to 2: no overflow. */
static void plane_range(uint32 at, fix16 ddx, fix16 ddy, const struct texturing *t,
                        const struct vertex *v, int32 count, fix16 *low, fix16 *high)
{
    *low = 0x7fffffff;
    *high = -0x7fffffff;
    for (; count > 0; count--, v++) {
        fix16 value = (fix16)(at + (uint32)mul_fix(ddx, v->x - (t->i << 16))
                              + (uint32)mul_fix(ddy, v->y - (t->j << 16)));

        if (value < *low)
            *low = value;
        if (value > *high)
            *high = value;
    }
}

void material_range(struct clamp_plan *clamp, const struct setup *s)
{
    clamp->u_low = clamp->v_low = clamp->v_high = 0;
    if (s->material->mapper == MAPPER_GOURAUD) {
        clamp->u_high = vertex_range(&s->vertices->s, s->count, &clamp->u_low);
        clamp->u_high += clamp->u_low;
        clamp->u_low &= ~0xffff;
        clamp->u_high |= 0xffff;
    } else {
        clamp->u_high = (s->material->map->width << 16) - 1;
        clamp->v_high = (s->material->map->height << 16) - 1;
    }
}

int32 material_leaves_range(const struct setup *s)
{
    const struct texturing *t = &s->texturing;
    int32 gouraud = s->material->mapper == MAPPER_GOURAUD;
    fix16 s_low, s_high, t_low = 0, t_high = 0, inset = INSET;
    struct clamp_plan clamp;

    if (is_steep(s->material, &s->span))
        return 1;
    if (gouraud && s->count == 3)
        return 0;               /* material_vertices has limited the shades */
    if (s->count == 3) {
        s_high = vertex_range(&s->vertices->s, 3, &s_low);
        s_high += s_low;
        t_high = vertex_range(&s->vertices->t, 3, &t_low);
        t_high += t_low;
    } else {                    /* the plane need not go through all vertices */
        inset = ON_PLANE;
        plane_range(t->u, t->dudx, t->dudy, t, s->vertices, s->count, &s_low, &s_high);
        if (!gouraud)
            plane_range(t->v, t->dvdx, t->dvdy, t, s->vertices, s->count, &t_low, &t_high);
    }
    material_range(&clamp, s);
    return s_low < clamp.u_low + inset || s_high > clamp.u_high - inset
        || (!gouraud && (t_low < inset || t_high > clamp.v_high - inset));
}
