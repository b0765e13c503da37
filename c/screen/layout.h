/* The place of a frame on the screen, and how it is shown. */
#ifndef SCREEN_LAYOUT_H
#define SCREEN_LAYOUT_H

#include "compiler.h"

/* PAL, in pixels of low resolution. The picture and the status lines below it take 276 of the
   286 lines that can be shown; the usual 256 are within them. */
enum screen_constants {
    SCREEN_WIDTH = 320, SCREEN_HEIGHT = 256,
    SCREEN_LEFT = 0x81, SCREEN_TOP = 32,            /* beam position, as in DIWSTRT */
    SCREEN_FETCH = 0x38,                            /* DDFSTRT for SCREEN_LEFT: colour clocks */
    STATUS_TOP = SCREEN_TOP + SCREEN_HEIGHT + 2,
    STATUS_COLUMNS = 80, STATUS_LINES = 2,
    STATUS_PITCH = STATUS_COLUMNS,                  /* bytes of a row of the status plane */
    STATUS_LINE = 9,                                /* rows from one status line to the next */
    STATUS_ROWS = 18
};

/* With FMODE 3 a plane's data comes 64 dots at a time. */
#define FETCH_DOTS 64

/* What kind of frames a screen shows. */
struct screen_form {
    int32 width, height;        /* of frames, pixels: the picture is at most 320x256, its width a multiple of 8 */
    int32 pixel_width, pixel_height;    /* of a pixel in the picture, of low resolution: 1 or 2 */
    uint32 format;              /* enum pixel_format */
    uint32 blitter;             /* 1: it does a part of screen_show's conversion, if memory allows. For frames in
                                   fast RAM: drawing in chip RAM is slowed by more than that saves */
};

struct screen_layout {
    int32 width, height;        /* of the frame, pixels */
    uint32 ham;                 /* 1: HAM8 */
    int32 dots;                 /* in a frame's pixel */
    int32 shift;                /* log2 of the dots in a pixel of low resolution: 0, 1 or 2 */
    uint32 twice;               /* 1: each row is shown twice */
    int32 shown_width, shown_height;                /* low resolution */
    int32 left, top;            /* on the screen, low resolution */
    int32 row_bytes, plane_bytes;
};

/* Finds the layout for frames. Returns 0, or the reason why they cannot be shown. */
const char *screen_layout_find(struct screen_layout *layout, const struct screen_form *form);

#endif
