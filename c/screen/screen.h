/* A screen for frames: two sets of planes in turn. screen_open takes the machine's display over: 50 fields a second, and
   two status lines below the picture; the system keeps running behind it, without keys and mouse. screen_open_intuition
   opens one of Intuition's, among those of other programs. All other calls are the same for both. The system gets
   everything back when the program ends, even after a break or a crash. */
#ifndef SCREEN_H
#define SCREEN_H

#include "coverage/touched.h"
#include "polygon/polygon.h"
#include "screen/blits.h"
#include "screen/display.h"
#include "screen/intuition.h"
#include "screen/layout.h"
#include "screen/planar.h"

struct screen_ways;

/* Must be zero before it is first opened. */
struct screen {
    const struct screen_ways *ways;     /* of the kind that was opened last */
    struct screen_layout layout;
    void (*convert)(const struct planar_plan *plan);
    void (*convert_part)(const struct planar_plan *plan);       /* the processor's part, beside the blitter's */
    uint32 rows_twice;          /* 1: the conversion writes each row twice, as the display shows it once */
    struct intuition *intuition;        /* of screen_open_intuition; 0 before */
    /* Memory for the planes and lists below. screen_close keeps it for the next screen_open; a
       larger screen allocates a second piece, so open the largest first. */
    uint8 *chip;
    int32 chip_bytes;
    uint8 *planes[2];           /* plane 0 of each set; in HAM8 both sets use the first one's
                                   planes 0 and 1 */
    uint16 *blank;              /* a copper list that shows nothing */
    uint16 *list[2], *palette[2];
    uint8 *status;
    uint8 *between[2];          /* what the blitter still merges, for each set; 0: the processor converts alone */
    uint8 *merged;              /* what it has merged once, where it may merge twice; or 0 */
    int32 merges_twice;         /* 1: it does from the next frame on; */
    int32 merged_twice[2];      /* it does what is between */
    struct touched had[2];      /* of each set, what may differ from the background that frames begin with */
    struct rectangle prepared;  /* around what was converted of the hidden set's frame */
    struct blit blits[BLITS_MAX];
    struct blit_list work;      /* the blitter's */
    int32 is_prepared;          /* 1: the hidden set's frame is in between */
    int32 hidden;               /* the set that is not shown: 0 or 1 */
    uint32 since;               /* display_fields when the screen was opened */
    int32 is_open;
    uint8 font[FONT_LETTERS * FONT_ROWS];
    uint8 text[STATUS_LINES][STATUS_COLUMNS];       /* the letters shown, 0: none */
};

/* Takes the screen over for frames: 8 bitplanes for chunky ones, HAM8 for 16 and 32 bits (planar.h has its
   errors). The picture is centred on black. HAM8 pictures of up to 160x128 are shown twice as large.
   Rows are doubled by the display, columns of chunky frames by their conversion, those of HAM8 by fewer dots.
   On failure prints the reason, closes the screen and returns 0. A screen that is open already is
   reopened for the new frames and is black meanwhile. */
int32 screen_open(struct screen *screen, const struct screen_form *form);

/* Opens a screen of Intuition's instead, for chunky frames: 320x256 dots of 8 planes in low resolution, from Kickstart 3.0
   on. Its two bitmaps, which conversions write, are shown in turn by ChangeScreenBuffer (one alone, where AROS's is wrong:
   pictures may then tear), its keys come from a window
   without borders, and the mouse has no pointer there. Interrupts, tasks and other screens go on as they were; several of
   these screens may be open, each with its own struct screen. Rows that are shown twice are converted twice; form.blitter
   is ignored, and there are no status lines. Fields are those of the display, 60 a second on an NTSC machine. On failure
   prints the reason, closes the screen and returns 0. Link this or screen_open: what is not called is not linked. */
int32 screen_open_intuition(struct screen *screen, const struct screen_form *form);

/* Sets the palette: 256 entries of 4 bytes, 0, red, green, blue, as at scene_header.palette_at.
   Does nothing in HAM8. */
void screen_palette(struct screen *screen, const uint8 *palette);

/* A frame's pixels and pitch are multiples of 8, as mem_alloc's memory is; a static array need not be. Its width and
   height are the form's. screen_convert, screen_convert_box, screen_prepare and screen_show return 0 and do nothing if
   that is not so, otherwise 1. */

/* Converts a frame into the hidden planes. */
int32 screen_convert(struct screen *screen, const struct frame *frame);

/* Converts a part of a frame. x and width are in pixels and multiples of 32 (of 16, if these are two dots wide);
   the box may also end at the frame's right edge. */
int32 screen_convert_box(struct screen *screen, const struct frame *frame, int32 x, int32 y,
                         int32 width, int32 height);

/* Shows the hidden planes from the next field on and returns when they are shown. The other set is
   hidden then. */
void screen_swap(struct screen *screen);

/* screen_post shows the hidden planes from a field on, counted as screen_fields does, or from the
   next field if that one is over; it returns at once (for Intuition's screens, in the field before that one). The other set becomes the hidden one, but
   stays on the screen until screen_wait returns. screen_wait returns when the posted planes are
   shown, with the number of their first field. screen_waits returns 1 if screen_wait would wait. */
void screen_post(struct screen *screen, uint32 field);
int32 screen_waits(const struct screen *screen);
uint32 screen_wait(const struct screen *screen);

/* screen_prepare converts a frame for screen_post, which comes next. With the blitter it only begins to, beside the
   planes, so the frame before may still wait to be shown; screen_post waits for that, and the blitter merges the rest
   while the program goes on. Without, that frame must be shown. screen_show does both, for the next field. touched: if all
   frames begin with one background, what this one has drawn over it; only that, and what the frame that was there has, is
   converted; 0: all of it. Functions that write planes, the palette or lists wait for the blitter first. */
int32 screen_prepare(struct screen *screen, const struct frame *frame, const struct touched *touched);
int32 screen_show(struct screen *screen, const struct frame *frame, const struct touched *touched);

/* Waits until the blitter has ended and its frame is shown, and gives the blitter back to the system: needed before the
   program prints, as its console may draw. */
void screen_finish(struct screen *screen);

/* Writes status line 0 or 1, 80 characters; the rest of the line after the text is cleared. */
void screen_text(struct screen *screen, int32 line, const char *text);

/* Returns the fields since the screen was opened. */
uint32 screen_fields(const struct screen *screen);

/* Returns the raw code of the next key that was pressed, or NO_KEY; of a screen of Intuition's while its window is active.
   Ctrl-C is a signal: break_asked. */
uint32 screen_key(const struct screen *screen);

/* Gives the screen back; it can be opened again. Does nothing if it is not open. */
void screen_close(struct screen *screen);

#endif
