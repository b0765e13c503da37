/* The figures that `show` prints below its picture, from frames drawn, measured and compared. */
#ifndef SHOW_FIGURES_H
#define SHOW_FIGURES_H

#include "frames/counts.h"

#define FIELDS 50               /* a second */

/* Sums over the frames measured with the current settings. */
struct measured {
    uint32 pixels, ticks;       /* of the polygons */
    uint32 different, compared; /* of the picture */
};

/* The frame rate since a field. */
struct rate {
    uint32 since, frames;
    uint32 spent;               /* fields that do not count */
    uint32 tenths;              /* the last result: frames in 10 seconds, 0 if none yet; */
    uint32 drawn;               /* the same if they were drawn alone */
    uint32 ticks;               /* that drawing has taken since the field */
};

void rate_begin(struct rate *rate, uint32 field);

/* Counts a frame shown at that field, and the ticks that its drawing took. */
void rate_count(struct rate *rate, uint32 field, uint32 ticks);

void measured_clear(struct measured *measured);

/* Returns 0 if a sum has no room for another frame. */
int32 measured_has_room(const struct measured *measured);

/* Adds the pixels of a frame's polygons and the ticks that drawing took. */
void measured_add(struct measured *measured, const struct scene_counts *counts, uint32 ticks);

/* Compares a frame with an exact one and adds the result; rows have no gaps. The exact one has the same size, or is twice
   as wide and high: the frame's pixels are then as large as four of its. */
void measured_compare(struct measured *measured, const struct frame *frame,
                      const struct frame *exact);

/* Add a figure to the line of text. */
void figures_rate(const struct rate *rate);
void figures_cost(const struct measured *measured);
void figures_error(const struct measured *measured);

#endif
