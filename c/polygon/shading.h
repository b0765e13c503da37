/* Levels of light for polygons that are lit by a table. */
#ifndef SHADING_H
#define SHADING_H

#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "span/scanline.h"

enum { LEVEL_BITS = 18 };       /* of a shade, below the number of its level */

/* Sets the light of a span plan to the row of a shade; returns 0 if the material has no light
   table. */
int32 shading_light(struct span_plan *span, const struct material *material, fix16 shade);

/* MAPPER_LIT_GOURAUD: the levels of a table's lines, on the plane of the polygon, cut to
   the frame already. No pixel has one beyond those of the vertices. shades: one a line. */
void shading_lines(struct span_plan *span, const struct sides *sides,
                   const struct vertex *vertices, int32 count, const struct rectangle *box,
                   uint32 *shades);

#endif
