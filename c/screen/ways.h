/* How a screen's pictures come to the display: what differs between the machine's own screen and one of Intuition's. */
#ifndef SCREEN_WAYS_H
#define SCREEN_WAYS_H

#include "screen/screen.h"

/* The functions of screen.h, for a screen that is open; close and finish: what they do once it is certain that there is
   something to do. post does not change `hidden`. */
struct screen_ways {
    void (*palette)(struct screen *screen, const uint8 *palette);
    void (*post)(struct screen *screen, uint32 field);
    int32 (*waits)(const struct screen *screen);
    uint32 (*wait)(const struct screen *screen);
    uint32 (*fields)(const struct screen *screen);
    uint32 (*key)(const struct screen *screen);
    void (*finish)(struct screen *screen);
    void (*close)(struct screen *screen);
};

/* Begins with a screen whose layout is found: nothing is drawn yet. */
void screen_begin(struct screen *screen, const struct screen_ways *ways);

/* Takes so many bytes of chip RAM, or keeps what there is. Returns 0 if memory is short. */
int32 screen_take_chip(struct screen *screen, int32 bytes);

/* Fills memory with 0, in steps of 4 bytes. */
void screen_clear(uint8 *from, int32 bytes);

/* Sets a plan's planes and pitches: the hidden set's. */
void screen_plan(const struct screen *screen, struct planar_plan *plan);

#endif
