/* The ways of polygon_draw. */
#ifndef THREE_H
#define THREE_H

#include "polygon/polygon.h"

/* Triangles by flat, Gouraud's or affine spans without perspective; not EDGES_SNAPPED, CLIP_VERTICES,
   GRADIENTS_SCANLINE or `whole`. The rules that such triangles do not need would take a quarter of a small one's
   time. */
polygon_routine polygon_draw_three;

/* All others; draws those too. */
polygon_routine polygon_draw_any;

/* The same without routines for triangles. */
polygon_routine polygon_draw_exact;

/* A polygon of at least three vertices, as one piece. */
polygon_routine polygon_draw_whole;

#endif
