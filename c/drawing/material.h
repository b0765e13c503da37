/* A polygon's vertices adapted to its material, and the range of u and v its mapper needs. */
#ifndef MATERIAL_H
#define MATERIAL_H

#include "polygon/setup.h"

/* Returns the vertices for the set-up: x and y in whole pixels with EDGES_INTEGER, in
   1/16 pixel with EDGES_SNAPPED; s and t in
   texels (rounded down to 1/65536), or with MAPPER_GOURAUD the shade as s, limited so that rounding
   gives no shade outside the vertices' range. */
const struct vertex *material_vertices(struct vertex *to, const struct vertex *from, int32 count,
                                       const struct material *material);

/* Sets the ranges that u and v of every pixel must stay in: MAPPER_GOURAUD, MAPPER_ARBITRARY. */
void material_range(struct clamp_plan *clamp, const struct setup *s);

/* Returns non-zero if a pixel might leave these ranges, by errors of edges and of the stepped
   plane. */
int32 material_leaves_range(const struct setup *s);

#endif
