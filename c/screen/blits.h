/* The blitter's part of chunky to planar: it merges what the processor has left, while the processor draws the next
   frame. Each end of a blit is an interrupt that starts the next one. */
#ifndef BLITS_H
#define BLITS_H

#include "screen/layout.h"

/* A blit: D = A where the mask is 1, B where it is 0; A or B is shifted. */
struct blit {
    uint32 control;             /* BLTCON0 and BLTCON1 */
    const uint8 *a, *b;         /* the first word; descending: the last one */
    uint8 *d;
    uint16 mask;                /* C */
    uint16 rows, words;         /* BLTSIZV, BLTSIZH: words that follow one another */
    uint16 unused;              /* so that longwords of an array are at multiples of 4 */
};

enum blits_constants {
    BLITS_MAX = 16              /* for a frame, at most */
};

/* Returns the bytes of chip RAM of the processor's part, which is between a frame and its planes. */
int32 blits_bytes(const struct screen_layout *layout);

/* Writes the blits that make rows of a frame's planes from the processor's part. merged: 0, or room for as much, if that
   part is one of those that the blitter merges twice. rows: 1 or more. Returns how many. */
int32 blits_make(struct blit *blits, const struct screen_layout *layout, uint8 *from, uint8 *merged, uint8 *planes,
                 int32 top, int32 rows);

/* Blits that are done one after the other. */
struct blit_list {
    const struct blit *next;    /* to start */
    int32 left;                 /* that are not done */
    const uint16 *list;         /* the copper's, posted when all are; 0: none */
    uint32 field;               /* for which it is posted: display_post */
};

/* src68k/amiga: contracts there. */
void blits_start(struct blit_list *list);
void blits_end(void);

#endif
