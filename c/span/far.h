/* Lines with perspective from their far ends to the near ones, by a table of reciprocals. u = K + C r with
   r = table[q]; K is constant over the polygon, C grows by the same from line to line. */
#ifndef FAR_H
#define FAR_H

#include "span/perspective.h"
#include "span/scanline.h"

enum far_constants {
    /* The table: 2^28 / (i + 1/2), rounded, for the indices i from LOWEST on. Pieces begin below 2^15 and grow
       by up to 2^14; those of even spans are up to 768 on. */
    FAR_LOWEST = 8192,
    FAR_COUNT = 40962 + 768,
    FAR_ORIGIN = 32768,         /* index 0 in the table */
    /* Pieces have h pixels, 16 at most, where the step of q a pixel is at most EVERY / h^2, q being 2^29 to 2^31.
       The chord is off by about h^2 / (4 L) pixels, L = q / step: at most 1 pixel with every16, 1/2 with every8. The
       table has room for steps up to MOST, in pieces of 2 half of that. */
    FAR_EVERY16 = 31,           /* log2 */
    FAR_EVERY8 = 30,
    FAR_MOST = 1 << 30,
    FAR_DEEP = 8,               /* q is shifted left by at most this, an even number: w varies by up to 512 */
    FAR_EVEN = 28,              /* log2: no q of a polygon that even spans draw is lower */
    FAR_NEVER = 32767,          /* above all indices less ORIGIN */
    /* A chord lags behind its curve. So pieces of even spans end where q is greater by its growth in AHEAD eighths
       of the most that a chord of the polygon is off, in pixels: they are ahead by that, and lag less. The root
       mean square of errors is least at 3 to 4; at 4 nothing lags by more than half of the most, but where pieces are
       long, more are too far ahead by as much. */
    FAR_AHEAD16 = 3,            /* every16 */
    FAR_AHEAD8 = 4,
    FAR_K_BITS = 3,             /* K is known to 1/8 unit, or to 2 if C is coarser */
    FAR_K_SCALE = 29,           /* where s and t have this scale, K is 2^32 times their growth over q's */
    FAR_BITS = 5,               /* C is (u - K) q in 1/8 units of 2.30, times 2^(this - 32); */
    FAR_BITS_COARSE = 1,        /* with FAR_COARSE bits less if it would not fit a word, or twice as many less */
    FAR_COARSE = 4,
    FAR_DOWN = 2048,            /* the most lines below the top vertex: the error of C's steps adds up */
    /* Texels from K to the polygon's farthest, as C r / 2^8 is less than 2^15 where i is 2^15: 256, less a
       quarter for pixels that rounded edges add; 16 times as many if C is coarse, and once more. */
    FAR_REACH = 192,
    /* Units by which lines are raised. For each texel from K quarters of a unit: 32768 / i for half an
       index, i / 8192 for half of r, together 5 at most where a line begins; and what q is low by times
       2^b / 2^13: the cuts of its steps, one a pixel and line, its plane's error, and CORNERS for s and t, which
       are a unit low at each corner, as u is near K there if it is so anywhere. For half a word of C where r is
       2^15: 1024; for the cuts of C's steps 2^b / 32 a line from the top vertex on, and LINES for its start's
       or, if it is coarse, without half a word, 16 or 256 times as much; 2^b for K, or 16 times as much; and 8
       for the rest. If C is coarser, what a texel adds is at most a quarter of a pixel where q is 1. */
    FAR_OFF_PART = 21,
    FAR_OFF_CORNERS = 32,
    FAR_OFF_WORD = 1024,
    FAR_OFF_LINES = 4,
    FAR_OFF = 8
};

/* Fills FAR_COUNT words; returns the address of index 0, for spans. */
const uint16 *reciprocals_make(uint16 *table);

/* The greatest steps of q a pixel, q being 2^29 to 2^31, by the pixels of a piece. */
struct far_lengths {
    uint32 most_16, most_8, most_4, most_2;
};

/* A line of a polygon that is drawn from its far end. */
struct far_line {
    uint32 q;                   /* of the first pixel drawn; even spans: twice that, less 2^31 */
    uint8 *from, *end;          /* pixels: drawn from the first to before the second or, leftwards, from before the
                                   first to the second; none if they have passed each other */
};

/* Everything that the lines need but their edges. */
struct far_place {
    struct far_line *lines;
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    uint32 q;                   /* where the first line's far edge is drawn from if its x is 0; */
    int32 dqdx, dqdy;           /* its steps */
};

/* Everything edges_far needs. */
struct far_edges {
    struct far_place place;
    const struct edge *far, *near;
    int32 fars, nears;          /* both cover the same lines */
};

/* Everything lines_far needs. */
struct far_lines {
    struct far_place place;
    const struct scanline *from;        /* left and last are read */
    int32 count;                /* lines, 1 or more */
    int32 leftwards;            /* 1: lines are drawn from their last pixel */
};

/* Everything a far span needs: it draws the whole table. */
struct far_span {
    struct far_line *lines;     /* even spans: with room for one more */
    int32 count;                /* lines, 1 or more */
    const uint8 *map;           /* MAP_PAGE */
    const uint16 *table;        /* at index 0 */
    const uint16 *ends;         /* even spans: that of the ends of pieces, some entries on */
    uint32 dq;                  /* step of q in the way that lines are drawn, 2.30, above 0 */
    const struct far_lengths *lengths;  /* of pieces, by this */
    int16 from_8, from_16;      /* even spans: the index less FAR_ORIGIN from which pieces have so many pixels */
    uint32 ku, kv;              /* K, 8.24 */
    uint32 dcu, dcv, cu, cv;    /* C, 16.16: 256 texels are 2^28 over r; 2^24 if coarse, 2^20 if coarser */
};

/* src68k/edge: contracts there. */
void edges_far(const struct far_edges *edges);
void lines_far(const struct far_lines *lines);

/* src68k/span: contracts there. */
void span_far_right(const struct far_span *span);
void span_far_left(const struct far_span *span);
void span_far_right_coarse(const struct far_span *span);
void span_far_right_coarser(const struct far_span *span);
void span_far_left_coarse(const struct far_span *span);
void span_far_left_coarser(const struct far_span *span);
void span_far_even_right(const struct far_span *span);
void span_far_even_left(const struct far_span *span);
void span_far_even_right_coarse(const struct far_span *span);
void span_far_even_right_coarser(const struct far_span *span);
void span_far_even_left_coarse(const struct far_span *span);
void span_far_even_left_coarser(const struct far_span *span);

#endif
