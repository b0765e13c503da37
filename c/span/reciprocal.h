/* Lines with perspective by a table of reciprocals, written by reciprocal_lines and read by the
   spans by reciprocals. u = K + C r with r = table[q]; K is constant over the polygon and C over
   the line. */
#ifndef RECIPROCAL_H
#define RECIPROCAL_H

#include "span/perspective.h"

enum reciprocal_constants {
    /* The table: 2^29 / (i + 1/2), rounded, for the indices i from LOWEST to 65535. Where w varies
       by a factor of up to 4 in a line, the smaller q's index is at least 2/3 of 2^14; where it
       varies by more than 6, the index is always below that. */
    RECIPROCAL_LOWEST = 10920,
    RECIPROCAL_COUNT = 65536 - RECIPROCAL_LOWEST,
    RECIPROCAL_ORIGIN = RECIPROCAL_LOWEST + RECIPROCAL_COUNT / 2,   /* index 0 in the table */
    RECIPROCAL_BITS = 6,            /* of a plan */
    RECIPROCAL_FURTHEST = 8,        /* a line's larger q is at least 2^(31 - this) */
    /* E, the texels from K that a line may reach with pieces of 16 and of 8 pixels so that its
       error stays within 1/32 texel, 2048 units. The error, E (32768 / i + i / 16384)
       + (r - r') / 2^(10 - piece) + 50 (see reciprocal_lines), is largest where w varies by 6 and i
       is 2/3 of 2^14: 3.667 E + 690 or 370; or where q is at its largest all along: 4.5 E + 50. */
    RECIPROCAL_REACH_16 = 369,
    RECIPROCAL_REACH_8 = 440,
    RECIPROCAL_REACH_WIDTH = 7,     /* pixels that cost a texel of reach: half a unit each */
    /* Units by which such lines are raised: E times 18 / 4, a constant for pieces of 16 and of 8
       pixels, and half a unit a pixel. */
    RECIPROCAL_OFF_PART = 18,
    RECIPROCAL_OFF_16 = 690,
    RECIPROCAL_OFF_8 = 370
};

/* Everything reciprocal_lines needs. */
struct reciprocal_plan {
    const struct perspective_plan *planes;  /* lines that are taken may be emptied in it */
    int32 bits;                         /* 6, or 3: K then may be 8 times as far away */
    struct number64 cu, cv;             /* C * 2^bits at the first line */
    struct number64 dcu, dcv;           /* steps of these a line */
    fix16 ku, kv;
    uint32 limit;                       /* of |C| r, 256 texels being 2^(32 - piece) */
    int32 piece;                        /* log2 of a piece's pixels: 3 or 4 */
    const uint16 *table;                /* at index 0 */
    struct reciprocal_line *to;
};

/* One line of n + 1 pixels. */
struct reciprocal_line {
    uint16 left;                /* x of the first pixel + EDGE_BIAS */
    int16 n;                    /* below 0: nothing to draw */
    uint32 u, v;                /* of the first pixel, 8.24 */
    uint32 q, dq;               /* first index, and its step a piece, if any; fraction:integer */
    int16 cu, cv;               /* C: times r, 256 texels are 2^(32 - piece) */
    uint16 first, last;         /* r of the first and the last pixel */
    int16 carry;                /* added to u's steps, in 2^-24: rounding, less v's borrow */
    int16 scale;                /* of q: shift of 64 C; bit 15: q is multiplied by 3/2 too */
};

/* Everything a span by reciprocals needs: it draws the whole table. */
struct reciprocal_span {
    const struct reciprocal_line *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* MAP_PAGE */
    const uint16 *table;        /* at index 0 */
};

/* Fills RECIPROCAL_COUNT words, and FAR_COUNT behind them; returns the address of index 0 of the first, for
   plan and span. */
const uint16 *reciprocals_make(uint16 *table);

/* src68k: contracts there. */
int32 reciprocal_find(struct reciprocal_plan *plan, int32 x, int32 y);
int32 reciprocal_lines(const struct reciprocal_plan *plan);
void span_reciprocal_8(const struct reciprocal_span *span);
void span_reciprocal_16(const struct reciprocal_span *span);

#endif
