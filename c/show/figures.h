/* The figures that `show` has below its picture, from frames that it drew, measured and compared. */
#ifndef SHOW_FIGURES_H
#define SHOW_FIGURES_H

#include "scene/counts.h"

#define FIELDS 50               /* a second */

/* Sums over the frames that were measured under the steps of now. */
struct measured {
    uint32 pixels, ticks;       /* of the polygons */
    uint32 different, compared; /* of the picture */
};

/* Frames since a field. */
struct rate {
    uint32 since, frames;
    uint32 spent;               /* fields that do not count */
    uint32 tenths;              /* frames in 10 seconds: the last result, 0 for none */
};

void rate_begin(struct rate *rate, uint32 field);

/* One more frame, at that field. */
void rate_count(struct rate *rate, uint32 field);

void measured_clear(struct measured *measured);

/* 0: a sum has no room for another frame. */
int32 measured_has_room(const struct measured *measured);

/* A frame's polygons, and the ticks that they took. */
void measured_add(struct measured *measured, const struct scene_counts *counts, uint32 ticks);

/* Two frames of one size, whose rows have no gaps. */
void measured_compare(struct measured *measured, const struct frame *frame,
                      const struct frame *exact);

/* Add to the text. */
void figures_rate(const struct rate *rate);
void figures_cost(const struct measured *measured);
void figures_error(const struct measured *measured);

#endif
