/* Captions and colours within a frame. */
#ifndef PICTURE_H
#define PICTURE_H

#include "polygon/polygon.h"

enum picture_constants {
    LETTER = 8                  /* pixels, width and height */
};

/* Returns the pixel of an enum pixel_format that is nearest to a colour, 0x00rrggbb. For chunky
   frames: the nearest of 256 palette entries of 4 bytes, 0, red, green, blue. */
uint32 picture_pixel(uint32 format, const uint8 *palette, uint32 colour);

/* Fills a rectangle, inside the frame, with one pixel. */
void picture_fill(const struct frame *frame, int32 x, int32 y, int32 width, int32 height,
                  uint32 pixel);

/* Writes text over the picture, from x on, in font_read's font; each dot is scale x scale pixels.
   Letters not wholly inside the frame are left out. */
void picture_text(const struct frame *frame, int32 x, int32 y, int32 scale, const char *text,
                  const uint8 *font, uint32 pixel);

#endif
