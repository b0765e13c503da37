/* Captions and colours within a frame. */
#ifndef PICTURE_H
#define PICTURE_H

#include "polygon/polygon.h"

enum picture_constants {
    LETTER = 8                  /* pixels, width and height */
};

/* The pixel of an enum pixel_format that is nearest to red, green and blue, 0x00rrggbb; in chunky
   frames of 256 palette entries of 4 bytes: 0, red, green, blue. */
uint32 picture_pixel(uint32 format, const uint8 *palette, uint32 colour);

/* A rectangle in one pixel, inside the frame. */
void picture_fill(const struct frame *frame, int32 x, int32 y, int32 width, int32 height,
                  uint32 pixel);

/* Letters of a font as font_read has it, each dot scale x scale pixels, on top of what is there,
   from x on; what is not inside the frame is left out. */
void picture_text(const struct frame *frame, int32 x, int32 y, int32 scale, const char *text,
                  const uint8 *font, uint32 pixel);

#endif
