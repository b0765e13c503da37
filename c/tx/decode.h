/* Tiles decoded ahead: what the passes over a line's pixels read instead of TMEM. */
#ifndef TX_DECODE_H
#define TX_DECODE_H

#include "tx/texel.h"

enum tx_decode_constants {
    TX_DECODE_BITS = 15         /* columns_bits + rows_bits, at most: all that fits into TMEM,
                                   mirrored; 128 KB of texels, 2 MB of quads */
};

/* Three points of a quad; R:B and G:A are pairs of 16-bit fields in one long, scaled by 32. A
   result is (rb + fs * rb_s + ft * rb_t) >> 5 & 0x00ff00ff in signed 32-bit numbers: a negative
   lower field borrows from the upper one. */
struct tx_triangle {
    uint32 rb, rb_s, rb_t, ga, ga_s, ga_t;
};

/* lower: fs + ft < 32, from the texel itself; upper: from the opposite one with 32 - fs and
   32 - ft. mean: 8 * (c00 + c10 + c01 + c11) + 16, for average filtering in the middle. */
struct tx_quad {
    struct tx_triangle lower, upper;
    uint32 mean_rb, mean_ga, spare[2];
};

/* A tile as texels of four bytes: those of relative coordinates are at
   [(t & mask_t) >> 5 << columns_bits | (s & mask_s) >> 5]. */
struct tx_decoded {
    const uint32 *texels;       /* R G B A from the highest byte on */
    const struct tx_quad *quads;    /* in the same order; 0 where none were asked for */
    uint16 mask_s, mask_t;      /* (columns - 1) << 5, (rows - 1) << 5 */
    uint16 columns_bits, rows_bits;
};

/* quad.c. Corners: R G B A from the highest byte on. */
void tx_quad_make(struct tx_quad *quad, uint32 c00, uint32 c10, uint32 c01, uint32 c11);

/* A decoded tile that is kept, with what it was made from. All 0 before the first use. */
struct tx_kept {
    struct tx_decoded decoded;
    const struct tx *tx;
    uint32 tile, tmem_generation, tile_generation;
    uint8 tlut, tlut_type;      /* of the modes, only these matter */
    uint8 spare[2];
    uint32 *texels;
    struct tx_quad *quads;
    uint32 texels_room, quads_room;     /* elements */
};

/* Makes *kept fit tile n, with quads or without, unless it does already; *made, if not 0, tells
   whether anything was done. Memory is the system's and kept for the next time; a larger tile
   takes new memory, and what it had stays taken until the program ends. Colours are tx_fetch's;
   of a TLUT entry's four copies only the first counts (loads make them equal). Not for YUV. */
enum tx_result tx_decode(const struct tx *tx, int32 n, int32 quads, struct tx_kept *kept,
                         int32 *made);

#endif
