/* Captions within a chunky frame. */
#ifndef PICTURE_H
#define PICTURE_H

#include "polygon/polygon.h"

enum picture_constants {
    LETTER = 8                  /* pixels, width and height */
};

/* The palette's entry that is brightest. */
uint8 picture_ink(const uint8 *palette);

/* A rectangle in one colour; x and width multiples of 4, inside the frame. */
void picture_fill(const struct frame *frame, int32 x, int32 y, int32 width, int32 height,
                  uint8 colour);

/* Letters of a font as font_read has it, on top of what is there, from x on; what is not inside the
   frame is left out. */
void picture_text(const struct frame *frame, int32 x, int32 y, const char *text, const uint8 *font,
                  uint8 ink);

#endif
