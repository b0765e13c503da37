/* Times of frames on the screen: drawing, conversion, and the field since which each is shown. */
#ifndef SHOW_TIMES_H
#define SHOW_TIMES_H

#include "screen/screen.h"

struct frame_time {
    uint32 drawing, showing;    /* ticks; the wait for the blitter is in the second, but not if a rate is held */
    uint32 shown;               /* field since which it was on the screen, from some field on */
    int32 rung;                 /* of a rate that is held, else -1 */
};

/* Shows a frame, as screen_show, and sets the ticks that this took. Returns the field since which the frame before it is
   shown. Uses the clock. */
uint32 times_show(struct screen *screen, const struct frame *frame, const struct touched *touched, uint32 *ticks);

/* Prints a line for each frame. */
void times_print(const struct frame_time *times, int32 count);

#endif
