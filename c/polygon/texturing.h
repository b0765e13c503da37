/* How u and v run over a polygon, and where they begin on its left edges. */
#ifndef TEXTURING_H
#define TEXTURING_H

#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "polygon/sides.h"

struct rectangle {
    int32 left, top, right, bottom;     /* pixels; right and bottom excluded */
};

/* All in 16.16 modulo 2^32. */
struct texturing {
    fix16 dudx, dvdx;           /* texels a pixel */
    int32 wraps;                /* v may wrap more than once in a span */
    uint32 spare;               /* 1: u's lowest bit is kept free for v's wrap ... */
    uint32 guard;               /* ... and holds this */

    /* GRADIENTS_PLANE: */
    fix16 dudy, dvdy;           /* texels a line */
    uint32 u, v;                /* at pixel (i, j) */
    int32 i, j;
};

/* The plane through top, bottom and apex. 0: they are on one line. chained: u and v
   share the addx chain, so a wrap of v must be provided for. */
int32 texturing_plane(struct texturing *t, const struct vertex *vertices,
                      const struct sides *sides, const struct rectangle *box,
                      enum start start, int32 chained);

/* A triangle's steps from its longest scanline, the one through the middle vertex. */
void texturing_longest(struct texturing *t, const struct vertex *vertices,
                       const struct sides *sides, const struct rectangle *box,
                       int32 chained);

/* u, v and their steps a line between an edge's ends, where it crosses the lines. */
void texturing_along(struct edge *edge, const struct side_edge *from);

/* u, v and their steps on left edges, GRADIENTS_PLANE or GRADIENTS_POLYGON. */
void texturing_edges(const struct texturing *t, struct edge *edge,
                     const struct side_edge *from, int32 count,
                     enum gradients gradients, enum start start);

#endif
