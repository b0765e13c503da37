/* A polygon's vertices adapted to its material, and the range of u and v its mapper needs. */
#ifndef MATERIAL_H
#define MATERIAL_H

#include "polygon/setup.h"
#include "polygon/shading.h"

/* Makes the vertices for the set-up and returns `to`: x and y in whole pixels with EDGES_INTEGER, in
   1/16 pixel with EDGES_SNAPPED; s and t in texels, to the nearest 1/65536, or with MAPPER_GOURAUD
   the shade as s, limited so that rounding gives no shade outside the vertices' range, and no shade
   or w. */
const struct vertex *material_made(struct vertex *to, const struct vertex *from, int32 count,
                                   const struct material *material);

/* Returns non-zero if material_made would change no vertex. */
static inline int32 material_takes_vertices(const struct material *material)
{
    return (material->edges == EDGES_EXACT || material->edges == EDGES_SUBPIXEL)
        && material->mapper != MAPPER_GOURAUD
        && (!material->map || material->map->scale == 65536);
}

/* As material_made, but returns the given vertices if they need no change. */
static inline const struct vertex *material_vertices(struct vertex *to, const struct vertex *from,
                                                     int32 count,
                                                     const struct material *material)
{
    if (material_takes_vertices(material))
        return from;
    if (material->mapper == MAPPER_GOURAUD && material->edges != EDGES_SNAPPED) {
        shade_vertices(to, from, count, material->edges == EDGES_INTEGER ? ~0xffff : ~0);
        return to;
    }
    return material_made(to, from, count, material);
}

/* Returns the least step, 16.16, with which errors of edges and of gradients may move u or v of a pixel
   by more than material_made allows in a polygon of that many lines; 0 if any step may. */
uint32 material_steep(const struct material *material, int32 lines);

/* MAPPER_GOURAUD, MAPPER_ARBITRARY: moves lines on which u or v of a pixel might leave the mapper's range. */
void clamp_lines(struct setup *s);

#endif
