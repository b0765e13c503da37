/* Tiles decoded ahead: what the passes over a line's pixels read instead of TMEM. */
#ifndef TX_DECODE_H
#define TX_DECODE_H

#include "tx/texel.h"

enum tx_decode_constants {
    TX_DECODE_BITS = 16,        /* columns_bits + rows_bits, at most: 256 KB of texels */
    TX_QUAD_BITS = 14           /* with quads: 1 MB of them */
};

/* Three points of a quad; R:B and G:A are pairs of 16-bit fields, scaled by 32. A result is
   (rb + fs * rb_s + ft * rb_t) >> 5 & 0x00ff00ff, as signed 32-bit numbers: a negative lower
   field borrows from the upper one, the end result's fields lie in 16 to 8192. */
struct tx_triangle {
    uint32 rb, rb_s, rb_t, ga, ga_s, ga_t;
};

/* lower: fs + ft < 32, from the texel itself; upper: from the opposite one with 32 - fs and
   32 - ft. average_rb, average_ga: the sum of all four, 8 * (c00 + c10 + c01 + c11) + 16, for
   average filtering where fs = ft = 16. */
struct tx_quad {
    struct tx_triangle lower, upper;
    uint32 average_rb, average_ga, spare[2];
};

/* A relative coordinate's place is [row << columns_bits | column], where column is
   (relative s & mask_s) >> 5. */
struct tx_decoded {
    const uint32 *texels;       /* R G B A from the highest byte on */
    const struct tx_quad *quads;    /* in the same order; 0 where none were asked for */
    uint16 mask_s, mask_t;      /* (columns - 1) << 5, (rows - 1) << 5 */
    uint16 columns_bits, rows_bits;
    /* What it was made from, to see whether it still holds. */
    uint32 tmem_generation, tile_generation, mode_generation;
    uint32 texels_room, quads_room;     /* elements of the memory that it has */
};

/* Before the first tx_decode. */
void tx_decoded_init(struct tx_decoded *decoded);

/* Makes decoded fit tile n, with quads or without; nothing is done where it still does.
   Memory is the system's and kept for the next time. Not for YUV tiles, whose chroma the
   passes cannot filter: TX_ILLEGAL_PAIR. */
enum tx_result tx_decode(const struct tx *tx, int32 n, int32 quads, struct tx_decoded *decoded);

#endif
