/* A screen of Intuition's with two bitmaps, and a window for its keys: src68k/amiga, contracts there. All are given back
   when the program ends, even after a break or a crash. */
#ifndef SCREEN_INTUITION_H
#define SCREEN_INTUITION_H

#include "screen/layout.h"

enum intuition_constants {
    INTUITION_PLANES = 8,
    INTUITION_COLOURS = 32,             /* that are set at once */
    POINTER_BYTES = 16                  /* of an image without rows, for the mouse's pointer */
};

/* As graphics.library has it. */
struct bitmap {
    uint16 row_bytes, rows;
    uint8 flags, depth;
    uint16 pad;
    uint8 *plane[INTUITION_PLANES];
};

struct intuition {
    struct intuition *next;             /* of those that are open */
    uint16 *pointer;                    /* set by the caller: POINTER_BYTES of chip RAM, 0 */
    uint32 intuition_base, graphics_base;
    uint32 screen, window, port;
    uint32 buffer[2];
    const struct bitmap *bitmap[2];     /* may be the same: one */
    int32 asked;                        /* messages of graphics.library that have not come: safe, shown */
    uint32 fields;                      /* since it was opened */
    uint32 since;                       /* the first field of the bitmap that is shown */
    uint8 server[24];                   /* struct Interrupt: counts fields */
};

/* LoadRGB32's table. */
struct intuition_colours {
    uint16 count, first;
    uint32 part[3 * INTUITION_COLOURS]; /* red, green, blue: the upper bits count */
    uint32 end;                         /* 0 */
};

int32 intuition_open(struct intuition *of);
void intuition_show(struct intuition *of, int32 set);
int32 intuition_waits(struct intuition *of);
void intuition_wait(struct intuition *of);
void intuition_field(struct intuition *of);
void intuition_colours_set(struct intuition *of, const struct intuition_colours *colours);
uint32 intuition_key(struct intuition *of);
void intuition_close(struct intuition *of);

#endif
