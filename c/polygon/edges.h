/* The edges of a polygon's sides, as the scanline steppers take them. */
#ifndef EDGES_H
#define EDGES_H

#include "polygon/sides.h"
#include "span/scanline.h"

/* An edge and what it comes from. */
struct side_edge {
    const struct vertex *upper, *lower;
    int32 top;                  /* its first line in the frame */
};

/* Writes the edges of one side, between lines top and bottom (excluded), which the
   polygon covers, but for u and v; returns how many. step: +1 or -1 through the
   vertices. from[] tells where each comes from. */
int32 edges_make(struct edge *edges, struct side_edge *from, const struct sides *sides,
                 const struct vertex *vertices, int32 count, int32 step,
                 int32 top, int32 bottom, enum edges kind);

/* x of an edge at its first line and its slope in 16.16, each within 1/2^17. */
fix16 edge_x(const struct side_edge *from);
fix16 edge_slope(const struct side_edge *from);

/* src68k/math: contracts there. */
void edge_rounded(struct edge *edge, const struct vertex *upper, const struct vertex *lower,
                  int32 line);
void edge_exact(struct edge *edge, const struct vertex *upper, const struct vertex *lower,
                int32 line);

#endif
