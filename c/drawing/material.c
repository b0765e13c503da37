#include "drawing/material.h"

#include "math/math.h"
#include "polygon/shading.h"
#include "triangle/triangles.h"

/* Steps from which INSET of parts/clamp.c may not be enough, and there the reasons. */
#define STEEP_256 (256 * 65536)
#define STEEP_4 (4 * 65536)
#define EDGES_32 4096           /* texels a pixel times lines */

/* Makes x and y of the set-up's vertices. */
static void set_places(struct vertex *to, const struct vertex *from, int32 count, enum edges edges)
{
    fix16 half = edges == EDGES_SNAPPED ? SNAPPED_HALF : 0;
    fix16 mask = edges == EDGES_SNAPPED ? ~SNAPPED_MASK : edges == EDGES_INTEGER ? ~0xffff : ~0;

    for (; count > 0; count--, to++, from++) {
        to->x = (from->x + half) & mask;
        to->y = (from->y + half) & mask;
    }
}

/* MAPPER_GOURAUD, EDGES_SNAPPED: makes s of the shades. Each has its own range, because polygons share
   such vertices. */
static void set_shades(struct vertex *to, const struct vertex *from, int32 count)
{
    for (; count > 0; count--, to++, from++) {
        fix16 low = from->shade, high = low;

        shade_limits(&low, &high);
        to->s = shade_limited(from->shade, low, high);
        to->t = 0;
    }
}

static void set_texels(struct vertex *to, const struct vertex *from, int32 count, fix16 scale)
{
    for (; count > 0; count--, to++, from++) {
        to->s = from->s;
        to->t = from->t;
        if (scale != 65536) {
            to->s = mul_round(from->s, scale);
            to->t = mul_round(from->t, scale);
        }
        to->shade = from->shade;
        to->w = from->w;
    }
}

const struct vertex *material_made(struct vertex *to, const struct vertex *from, int32 count,
                                   const struct material *material)
{
    set_places(to, from, count, (enum edges)material->edges);
    if (material->mapper == MAPPER_GOURAUD)
        set_shades(to, from, count);
    else
        set_texels(to, from, count, material->map ? material->map->scale : 65536);
    return to;
}

uint32 material_steep(const struct material *material, int32 lines)
{
    const uint32 rounded = (uint32)EDGES_32 / (uint32)(lines + 1);

    if (material->gradients != GRADIENTS_PLANE)
        return 0;
    if (EDGES_ARE_EXACT(material->edges))
        return STEEP_256;
    return material->clip == CLIP_VERTICES ? STEEP_4
         : rounded < STEEP_256 >> 16 ? rounded << 16 : STEEP_256;
}
