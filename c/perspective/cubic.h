/* Polygons with perspective that are drawn by cubics from the far ends of their lines. */
#ifndef PERSPECTIVE_CUBIC_H
#define PERSPECTIVE_CUBIC_H

#include "perspective/far.h"
#include "span/cubic.h"

/* Finds all of a span but its lines and its map. Returns 0 if the polygon is not drawn this way. */
int32 cubic_find(struct cubic_span *span, const struct setup *s, const struct depth *depth);

/* Draws it. has_lines: its lines are in the scanline table; else edges are inside the frame. */
void cubic_draw(const struct setup *s, struct cubic_span *span, int32 has_lines);

#endif
