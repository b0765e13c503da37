/* Captions and colours within a frame of one byte a pixel. */
#ifndef PICTURE_H
#define PICTURE_H

#include "polygon/polygon.h"

enum picture_constants {
    LETTER = 8                  /* pixels, width and height */
};

/* Returns the one of 256 palette entries of 4 bytes, 0, red, green, blue, that is nearest to a colour, 0x00rrggbb. */
uint32 picture_pixel(const uint8 *palette, uint32 colour);

/* Writes text in font_read's font on a ground, at the frame's lower left corner. Letters that are not wholly inside the
   frame are left out. */
void picture_caption(const struct frame *frame, const char *text, const uint8 *font, uint32 ink, uint32 ground);

#endif
