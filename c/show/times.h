/* Times of frames on the screen: drawing, conversion, and the field since which each is shown. */
#ifndef SHOW_TIMES_H
#define SHOW_TIMES_H

#include "screen/screen.h"

struct frame_time {
    uint32 drawing, showing;    /* ticks; the wait for the blitter is in the second */
    uint32 shown;               /* field since which it was on the screen, from some field on */
};

/* Shows a frame, as screen_show, and sets `showing`. Returns the field since which the frame before it is shown. Uses the clock. */
uint32 times_show(struct screen *screen, const struct frame *frame, const struct touched *touched,
                  struct frame_time *time);

/* Prints a line for each frame. */
void times_print(const struct frame_time *times, int32 count);

#endif
