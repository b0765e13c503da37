/* Texture rectangles: the drawing processor's own primitive. */
#ifndef N64_RECTANGLE_H
#define N64_RECTANGLE_H

#include "n64/polygons/unit.h"

struct n64_rectangle {
    int32 left, top, right, bottom;     /* pixels; right and bottom excluded */
    int32 s, t;                 /* s10.5, at the upper left pixel */
    int32 dsdx, dtdy;           /* s5.10: 1024 is a texel a pixel; dsdx of copy mode: four pixels */
    int32 flip;                 /* s runs down and t to the right */
};

/* Draws a rectangle with a material's unit: the tiles' first level, without perspective and shade.
   In copy mode the frame must have 2 bytes a pixel, and the texels are its pixels. s and t, up to
   the right and bottom edge, have the range of a polygon's. If it returns POLYGON_REFUSED,
   unit->result has the reason. */
enum polygon_result n64_rectangle_draw(const struct frame *frame,
                                       const struct n64_rectangle *rectangle,
                                       const struct material *material,
                                       const struct drawing *drawing);

#endif
