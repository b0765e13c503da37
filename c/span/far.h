/* Lines with perspective from their far ends to the near ones, by a table of reciprocals. u = K + C r with
   r = table[q]; K is constant over the polygon, C grows by the same from line to line. */
#ifndef FAR_H
#define FAR_H

#include "span/reciprocal.h"
#include "span/scanline.h"

enum far_constants {
    /* The table: 2^28 / (i + 1/2), rounded, for the indices i from LOWEST on. Pieces begin below 2^15 and grow
       by up to 2^14. */
    FAR_LOWEST = 8192,
    FAR_COUNT = 40962,
    FAR_ORIGIN = 32768,         /* index 0 in the table */
    /* Pieces have h pixels where the step of q a pixel is at most EVERY / h^2, q being 2^29 to 2^31. The chord is
       off by about h^2 / (4 L) pixels, L = q / step: at most 1 pixel with every16, 1/2 with every8, which has no
       pieces of 16. The table has room for steps up to MOST, in pieces of 2 half of that. */
    FAR_EVERY16 = 31,           /* log2 */
    FAR_EVERY8 = 30,
    FAR_MOST = 1 << 30,
    FAR_DEEP = 8,               /* q is shifted left by at most this, an even number: w varies by up to 512 */
    FAR_EVEN = 28,              /* log2: no q of a polygon that even spans draw is lower */
    FAR_BITS = 3,               /* of a reciprocal_plan */
    FAR_COARSE = 4,             /* bits that C lacks if it does not fit a word */
    /* Texels from K to the polygon's farthest, as C r / 2^8 is less than 2^15 where i is 2^15: 256, less a
       quarter for pixels that rounded edges add; and 16 times as many if C is coarse. */
    FAR_REACH = 192,
    /* Units by which lines are raised. For each texel from K quarters of a unit: 32768 / i for half an
       index, i / 8192 for half of r, together 5 at most where a line begins; and the cuts of q's steps, one a
       pixel and line, times 2^b / 2^13. For half a word of C where r is 2^15: 1024; for the cuts of C's steps
       2^b / 32 a line, or if it is coarse, without half a word, 2^b / 2; and 8 for the rest. */
    FAR_OFF_PART = 21,
    FAR_OFF_WORD = 1024,
    FAR_OFF = 8,
    /* Planes instead of K and C: u less its base is S r / 2^16 units, S below 2^31 where q is 2^31, and with
       room for pieces that end beyond the polygon. Their steps' cuts, one a pixel and line, are 2^b / 2 units
       each, with 2^b times the pixels and lines so limited 1/16 texel. */
    FAR_SCALE = 28,             /* S is units times q / 2^this */
    FAR_RANGE = 1536,           /* texels from the base */
    FAR_WAY = 8192,
    FAR_STEP = 1 << 26,         /* of S a pixel, times 2^b: a piece's 16 steps, beyond the polygon too, and S,
                                   3/8 of 2^31, fit 32 bits; where q is 2^31, 128 texels a pixel */
    FAR_OFF_PLANES = 32         /* units by which lines are raised, 16 of them for a piece's steps */
};

/* Fills FAR_COUNT words; returns the address of index 0, for spans. */
const uint16 *reciprocals_make(uint16 *table);

/* The greatest steps of q a pixel, q being 2^29 to 2^31, by the pixels of a piece. */
struct far_lengths {
    uint32 most_16, most_8, most_4, most_2;
};

/* Everything a far span needs: it draws the whole table. */
struct far_span {
    const struct scanline *lines;       /* left and last are read */
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* MAP_PAGE */
    const uint16 *table;        /* at index 0 */
    uint32 q;                   /* 2.30, at pixel -EDGE_BIAS of the first line; */
    int32 dqdx, dqdy;           /* its steps */
    uint32 dq;                  /* and the magnitude of dqdx, above 0 */
    struct far_lengths lengths; /* of pieces, by this */
    int32 even;                 /* even spans: log2 of a piece's pixels, 4, 3 or 2 */
    uint32 ku, kv;              /* K, 8.24 */
    uint32 dcu, dcv, cu, cv;    /* C, 16.16: 256 texels are 2^28 or, if coarse, 2^24, over r */
};

/* The same for a far planes span. */
struct far_planes_span {
    const struct scanline *lines;
    int32 count;
    uint8 *row;
    int32 pitch;
    const uint8 *map;
    const uint16 *table;
    uint32 q;                   /* as in a far_span; */
    int32 dqdx, dqdy;
    int32 s, dsdx, dsdy;        /* S and T, there too */
    int32 t, dtdx, dtdy;
    fix16 u, v;                 /* the bases */
    struct far_lengths lengths;
};

/* src68k/span: contracts there. */
void span_far_planes_right(const struct far_planes_span *span);
void span_far_planes_left(const struct far_planes_span *span);
void span_far_right(const struct far_span *span);
void span_far_left(const struct far_span *span);
void span_far_right_coarse(const struct far_span *span);
void span_far_left_coarse(const struct far_span *span);
void span_far_even_right(const struct far_span *span);
void span_far_even_left(const struct far_span *span);
void span_far_even_right_coarse(const struct far_span *span);
void span_far_even_left_coarse(const struct far_span *span);

#endif
