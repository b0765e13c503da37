/* The machine's screen, taken over for frames: two sets of planes by turns, 50 fields a second,
   and two status lines below the picture. The system goes on behind it, without keys and mouse,
   and gets everything back when the program ends, whichever way. */
#ifndef SCREEN_H
#define SCREEN_H

#include "polygon/polygon.h"
#include "screen/display.h"
#include "screen/layout.h"
#include "screen/planar.h"

/* Zeroed before it is opened the first time. */
struct screen {
    struct screen_layout layout;
    void (*convert)(const struct planar_plan *plan);
    /* Memory of all that follows, kept when the screen is closed for the next one; a larger one
       takes its own beside it, so open the largest first. */
    uint8 *chip;
    int32 chip_bytes;
    uint8 *planes[2];           /* plane 0 of either set, in HAM8 one for both */
    uint16 *blank;              /* a copper list that shows nothing */
    uint16 *list[2], *palette[2];
    uint8 *status;
    int32 hidden;               /* the set that is not shown: 0 or 1 */
    uint32 since;               /* display_fields when it was opened */
    int32 is_open;
    uint8 font[FONT_LETTERS * FONT_ROWS];
    uint8 text[STATUS_LINES][STATUS_COLUMNS];       /* the letters that are there, 0: none */
};

/* Takes the screen over for frames of this size, at most 320x256 and the width a multiple of 8, and
   enum pixel_format: 8 bitplanes for chunky ones, HAM8 for those of 16 and 32 bits (planar.h has its
   errors); centred, black around. HAM8 frames of up to 160x128 are shown twice as large. Prints
   what is lacking and returns 0 where it cannot. One that is open changes its frames,
   black meanwhile, and is closed where it cannot. */
int32 screen_open(struct screen *screen, int32 width, int32 height, uint32 format);

/* 256 entries of 4 bytes: 0, red, green, blue, as scene_header.palette_at. In HAM8: none. */
void screen_palette(struct screen *screen, const uint8 *palette);

/* Turns a frame, or a part of it, into the hidden planes; pixels and pitch multiples of 8. */
void screen_convert(struct screen *screen, const struct frame *frame);

/* x and width in pixels, multiples of 32, or up to the frame's right edge. */
void screen_convert_box(struct screen *screen, const struct frame *frame, int32 x, int32 y,
                        int32 width, int32 height);

/* Shows the hidden planes from the next field on, and returns when they are shown: the others are
   hidden then. */
void screen_swap(struct screen *screen);

/* Shows the hidden planes from a field on, of screen_fields, or from the next one where it is over,
   and returns at once. The others are hidden then, but shown until screen_wait returns: when what
   was posted is shown, with the field since when it is. screen_waits: whether it would wait. */
void screen_post(struct screen *screen, uint32 field);
int32 screen_waits(const struct screen *screen);
uint32 screen_wait(const struct screen *screen);

/* Writes status line 0 or 1: 80 characters, what is behind the text's end is cleared. */
void screen_text(struct screen *screen, int32 line, const char *text);

/* Fields since it was opened. */
uint32 screen_fields(const struct screen *screen);

/* Gives the screen back; it can be opened again. Nothing is done where it is not open. */
void screen_close(struct screen *screen);

#endif
