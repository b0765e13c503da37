/* What a material makes of a polygon's vertices, and the range its mapper needs. */
#ifndef MATERIAL_H
#define MATERIAL_H

#include "polygon/setup.h"

/* The vertices as the set-up takes them: x and y in whole pixels where edges are, s and
   t in texels (rounded down to 1/65536), or the shade instead: limited so that rounding
   leads to no shade outside the vertices' range. */
const struct vertex *material_vertices(struct vertex *to, const struct vertex *from, int32 count,
                                       const struct material *material);

/* The ranges in which u and v of every pixel must lie: MAPPER_GOURAUD, MAPPER_ARBITRARY. */
void material_range(struct hold_plan *hold, const struct setup *s);

/* Whether a pixel might leave them, as edges are and the plane is stepped. */
int32 material_leaves_range(const struct setup *s);

#endif
