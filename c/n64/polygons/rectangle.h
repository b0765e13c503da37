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

/* Draws one by the unit of a material, without perspective and shade, of its tiles the first level.
   In copy mode the frame has 2 bytes a pixel, which are the texels as they are. s and t, up to
   where right and bottom begin, are as those of a polygon. POLYGON_REFUSED: unit->result says
   why. */
enum polygon_result n64_rectangle_draw(struct renderer *renderer,
                                       const struct n64_rectangle *rectangle,
                                       const struct material *material);

#endif
