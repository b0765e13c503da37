/* The edges of a polygon's sides, as the scanline steppers take them. */
#ifndef EDGES_H
#define EDGES_H

#include "polygon/sides.h"
#include "span/scanline.h"

/* Pixels of the frame; right and bottom excluded. */
struct rectangle {
    int32 left, top, right, bottom;
};

/* Return x of an edge at its first line in the frame, and its slope: 16.16, each within 1/2^17. */
fix16 edge_x(const struct edge *edge);
fix16 edge_slope(const struct edge *edge);

/* Returns the number of pixels in a scanline table. */
uint32 lines_pixels(const struct scanline *line, int32 count);

/* src68k/polygon: contracts there. The latter two are for assembly. */
void edges_make(struct edge_plan *plan, const struct sides *sides, const struct rectangle *box,
                int32 exact);
void edges_make_upright(struct edge_plan *plan, const struct sides *sides,
                        const struct rectangle *box);
void edge_exact_across(void);
void edge_rounded_across(void);

#endif
