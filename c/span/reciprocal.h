/* Lines with perspective by a table of reciprocals: what reciprocal_lines writes and the
   spans by reciprocals read. u = K + C r, r being table[q]: K belongs to the polygon, C to
   the line. */
#ifndef RECIPROCAL_H
#define RECIPROCAL_H

#include "span/perspective.h"

enum reciprocal_constants {
    /* The table: 2^29 / (i + 1/2), rounded, of the indices i from LOWEST to 65535. Where w
       differs up to 4 times in a line, the smaller q's index is 2/3 of 2^14 at least, and
       where it does more than 6 times never. */
    RECIPROCAL_LOWEST = 10920,
    RECIPROCAL_COUNT = 65536 - RECIPROCAL_LOWEST,
    RECIPROCAL_ORIGIN = RECIPROCAL_LOWEST + RECIPROCAL_COUNT / 2,   /* where indices are 0 */
    RECIPROCAL_FURTHEST = 8,        /* a line's larger q is at least 2^(31 - this) */
    /* Texels from K, E, that a line may reach with pieces of 16 and of 8 pixels, so that it
       keeps to 1/32 texel, 2048 units. E (32768 / i + i / 16384) + (r - r') / 2^(10 - piece)
       + 50 (see reciprocal_lines) is most with w 6 times apart, i = 2/3 of 2^14: 3.667 E +
       690 or 370; or with q all along at its largest: 4.5 E + 50. */
    RECIPROCAL_REACH_16 = 369,
    RECIPROCAL_REACH_8 = 440,
    RECIPROCAL_REACH_WIDTH = 7,     /* pixels a texel less: each one takes half a unit */
    /* Units that such lines are raised by: E quarters of 18, and as much as does not depend
       on E, in pieces of 16 and of 8 pixels, and half a unit a pixel. */
    RECIPROCAL_OFF_PART = 18,
    RECIPROCAL_OFF_16 = 690,
    RECIPROCAL_OFF_8 = 370
};

/* Everything reciprocal_lines needs. */
struct reciprocal_plan {
    const struct perspective_plan *planes;  /* their lines may be emptied */
    struct number64 cu, cv;             /* C * 64 at the first line */
    struct number64 dcu, dcv;           /* a line */
    fix16 ku, kv;
    uint32 limit;                       /* of |C| r, 256 texels being 2^(32 - piece) */
    int32 piece;                        /* log2 of its pixels: 3 or 4 */
    const uint16 *table;                /* its index 0 */
    struct reciprocal_line *to;
};

/* One line of n + 1 pixels. */
struct reciprocal_line {
    uint16 left;                /* x of the first pixel + EDGE_BIAS */
    int16 n;                    /* below 0: nothing to draw */
    uint32 u, v;                /* of the first pixel, 8.24 */
    uint32 q, dq;               /* index and step of a piece, if it has one; fraction:integer */
    int16 cu, cv;               /* C: times r, 256 texels are 2^(32 - piece) */
    uint16 first, last;         /* r of the first and the last pixel */
    int16 carry;                /* added to u's steps, in 2^-24: rounding, less v's borrow */
    int16 scale;                /* of q: shift of 64 C, bit 15 set where 3/2 comes on top */
};

/* Everything a span by reciprocals needs: it draws the whole table. */
struct reciprocal_span {
    const struct reciprocal_line *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* MAP_PAGE */
    const uint16 *table;        /* its index 0 */
};

/* Fills RECIPROCAL_COUNT words; returns the place of index 0, which plan and span take. */
const uint16 *reciprocals_make(uint16 *table);

/* src68k: contracts there. */
int32 reciprocal_find(struct reciprocal_plan *plan, int32 x, int32 y);
int32 reciprocal_lines(const struct reciprocal_plan *plan);
void span_reciprocal_8(const struct reciprocal_span *span);
void span_reciprocal_16(const struct reciprocal_span *span);

#endif
