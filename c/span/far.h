/* Lines with perspective from their far ends to the near ones, by a table of reciprocals. u = K + C r with
   r = table[q]; K is constant over the polygon, C grows by the same from line to line. */
#ifndef FAR_H
#define FAR_H

#include "span/reciprocal.h"
#include "span/scanline.h"

enum far_constants {
    /* The table: 2^28 / (i + 1/2), rounded, for the indices i from LOWEST to 65535, as signed words. The
       nearest q of a polygon has the index 2^15, so w may vary by a factor of 4 in it; a line's last piece
       goes beyond it, to less than twice that index. */
    FAR_LOWEST = 8192,
    FAR_COUNT = 65536 - FAR_LOWEST,
    FAR_ORIGIN = FAR_LOWEST + FAR_COUNT / 2,    /* index 0 in the table */
    FAR_STEEP = 1 << 25,        /* steps of q a pixel are below this, 1.0 being 2^30: 17 of them and the
                                   nearest q have less than 31 bits */
    FAR_BITS = 3,               /* of a reciprocal_plan */
    FAR_COARSE = 4,             /* bits that C lacks if it does not fit a word */
    /* Units by which lines are raised. For each texel from K quarters of a unit: 32768 / i for half an
       index, i / 8192 for half of r, together 5 where i is 2^13 or 2^15; the index less 2^11 cuts of its
       steps, 1/4 at 2^13. For half a word of C where r is 2^15: 64 times 2^log2 of a piece's pixels, and 2
       for the cuts of C's steps and the rest. If C is coarse, starts take it whole: half a unit a line for
       its cuts, and 8. */
    FAR_OFF_PART = 21,
    FAR_OFF = 66,
    FAR_PIECES_8 = 64           /* every16: pieces of 8 pixels if q is below so many steps somewhere */
};

/* The table, behind that of reciprocals_make: at index 0, both. */
#define FAR_TABLE(reciprocals) ((reciprocals) + RECIPROCAL_COUNT / 2 + FAR_COUNT / 2)

/* Everything a far span needs: it draws the whole table. Of q and C, integers are indices and words. */
struct far_span {
    const struct scanline *lines;       /* left and last are read */
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* MAP_PAGE */
    const uint16 *table;        /* at index 0 */
    uint32 q;                   /* less FAR_ORIGIN, at pixel -EDGE_BIAS of the first line, 16.16; */
    int32 dqdx, dqdy;           /* its steps */
    uint32 dq;                  /* and that of a piece, above 0; fraction:integer */
    uint32 ku, kv;              /* K, 8.24 */
    uint32 dcu, dcv, cu, cv;    /* C: 256 texels are 2^(32 - log2 of a piece's pixels) or, if coarse,
                                   2^(28 - that), over r; fraction:integer, rounded */
};

/* src68k/span: contracts there. */
void span_far_16_right(const struct far_span *span);
void span_far_16_left(const struct far_span *span);
void span_far_8_right(const struct far_span *span);
void span_far_8_left(const struct far_span *span);
void span_far_16_right_coarse(const struct far_span *span);
void span_far_16_left_coarse(const struct far_span *span);
void span_far_8_right_coarse(const struct far_span *span);
void span_far_8_left_coarse(const struct far_span *span);

#endif
