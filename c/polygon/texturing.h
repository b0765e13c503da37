/* Steps of u and v over a polygon, and their starts on its left edges. */
#ifndef TEXTURING_H
#define TEXTURING_H

#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "polygon/sides.h"

/* All in 16.16 modulo 2^32. */
struct texturing {
    fix16 dudx, dvdx;           /* texels a pixel */
    int32 wraps;                /* v may wrap more than once in a span */
    uint32 u_cut, v_cut;        /* number of low bits that are 0 in u, v and steps: the span does
                                   not keep them, or u's lowest is reserved for v's wrap */
    uint32 wrap_bit;             /* value of u's reserved bit: 1 if v falls; else 0 */

    /* GRADIENTS_PLANE: */
    fix16 dudy, dvdy;           /* texels a line */
    uint32 u, v;                /* at pixel (i, j) */
    int32 i, j;
};

/* How u and v share an addx chain, in which a wrap of v must be handled. */
enum chain {
    CHAIN_NONE,                 /* no shared chain */
    CHAIN_ANYWHERE,             /* v may be anywhere */
    CHAIN_PLANE,                /* v is on the plane, within the box */
    CHAIN_WHOLE,                /* the same, but u keeps all bits: a single wrap sets wraps */
    CHAIN_SHADES                /* no shared chain, and no v at all */
};

/* Low bits that spans of tiles, of columns and of light do not keep. */
enum cuts {
    CUT_TILED_V = 1,
    CUT_COLUMNS = 3,
    CUT_LEVEL = 2
};

/* src68k/polygon: contracts there. */
void texturing_plane(struct texturing *t, const struct sides *sides,
                     const struct rectangle *box, enum chain chain);
void texturing_wrap(struct texturing *t, const struct rectangle *box, enum chain chain);
void texturing_starts(const struct texturing *t, struct edge *edges, int32 count);
void texturing_longest(struct texturing *t, const struct sides *sides,
                       const struct rectangle *box, enum chain chain);
void texturing_along(struct edge *edge);
void texturing_edges(const struct texturing *t, struct edge *edges, int32 count, int32 width);

/* Returns v at the middle of the box, from which texturing_wrap looks for wraps; (i, j) of gentle planes
   is elsewhere. */
uint32 texturing_middle(const struct texturing *t, const struct rectangle *box);

/* Returns value rounded up to a multiple of 2^cut. */
static inline uint32 texturing_raised(uint32 value, uint32 cut)
{
    return ((value + (1u << cut) - 1) >> cut) << cut;
}

#endif
