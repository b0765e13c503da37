/* Pixels of the frames that a texture engine draws into. */
#ifndef N64_PIXELS_H
#define N64_PIXELS_H

#include "compiler.h"

/* Returns the pixel of a colour (R G B A from the highest byte on): in a frame of 4 bytes a pixel
   the colour itself, in one of 2 5/5/5/1, the lower bits cut off. */
uint32 n64_pixel_of(uint32 colour, int32 pixel_bytes);

/* Writes pixel x of a row of 2 or 4 bytes a pixel. */
void n64_pixel_write(uint8 *row, int32 x, int32 pixel_bytes, uint32 pixel);

#endif
