/* What a material makes of a polygon's vertices, and the range its mapper needs. */
#ifndef MATERIAL_H
#define MATERIAL_H

#include "polygon/polygon.h"
#include "polygon/texturing.h"
#include "span/scanline.h"

/* The vertices as the set-up takes them: x and y in whole pixels where edges are, s and
   t in texels (rounded down to 1/65536), or the shade instead: limited so that rounding
   leads to no shade outside the vertices' range. */
const struct vertex *material_vertices(const struct vertex *from, int32 count,
                                       const struct material *material);

/* The range in which u and v of every pixel must lie, as edge_hold takes it; 0: no
   pixel can leave it. vertices: as material_vertices gives them; t: of the plane, where
   gradients are. */
int32 material_range(struct hold_plan *hold, const struct material *material,
                     const struct vertex *vertices, int32 count,
                     const struct texturing *t, const struct span_plan *span);

#endif
