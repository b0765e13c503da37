/* Lines with perspective: what perspective_lines writes and the perspective spans read. */
#ifndef SPAN_PERSPECTIVE_H
#define SPAN_PERSPECTIVE_H

#include "math/math.h"
#include "span/scanline.h"

enum perspective_constants {
    /* log2 of a piece's pixels; of curves the longest one's. */
    PERSPECTIVE_PIECE_EVERY16 = 4,
    PERSPECTIVE_PIECE_EVERY8 = 3,
    PERSPECTIVE_PIECE_PIXEL = 5,
    PERSPECTIVE_PIECE_FINE = 4,
    /* Curves' bend, rounded up: 64 log2(6 / (9 sqrt 3) / what they may be off), that being
       1/32 or 1/128 texel, in 1/65536, less the rounding of longest^2 / 8 + 8 units. */
    PERSPECTIVE_BEND_PIXEL = -785,
    PERSPECTIVE_BEND_FINE = -656,
    /* What a line may be off for being level, in 1/65536 texel, and the widest polygon with
       such lines: their steps take a unit a pixel as well, and both together stay
       inside 1/32 or 1/128 texel. Straight pieces: level is what changes by nothing. */
    PERSPECTIVE_LEVEL_PIXEL = 1020,
    PERSPECTIVE_LEVEL_FINE = 128,
    PERSPECTIVE_LEVEL_WIDTH = 380,          /* of the latter; of others any frame's */
    /* Units that lines are raised by: a part of the way cuts 3, of pieces of m pixels ends
       are cut by m - 1 and the last one's steps by m; curves round by longest^2 / 8 + 8. */
    PERSPECTIVE_RAISE_EVERY16 = 34,
    PERSPECTIVE_RAISE_EVERY8 = 18,
    PERSPECTIVE_RAISE_PIXEL = 139,
    PERSPECTIVE_RAISE_FINE = 43
};

/* A value over the screen: at pixel (i, j), and what it grows by a pixel and a line. */
struct screen_plane {
    struct number64 at, dx, dy;
};

/* Everything perspective_lines needs. With w0 the least w of the polygon, q is w0 / w, 1.0
   being 2^62; s / q.hi is u less its base, t / q.hi is v less its base, 16.16. Rounded
   edges may lie a little outside the polygon: the limits hold there. */
struct perspective_plan {
    struct scanline *lines;             /* left and last are read */
    int32 count;                        /* lines, 1 or more */
    struct screen_plane q, s, t;        /* at pixel (left, the first line) */
    int32 left;                         /* no pixel of the table lies before it */
    int32 q_low;                        /* of q.hi; above 0 */
    int32 gentle;                       /* q.dx, q.dy, s.dx and t.dx: no 2^30 of q.hi's units */
    fix16 u, u_low, u_high;             /* the base, a unit above a texel; u less the base */
    fix16 v, v_low, v_high;
    int32 bend;                         /* curves: PERSPECTIVE_BEND_...; else 0 */
    struct perspective_line *to;
};

/* One line of n + 1 pixels. Pixel k has the weight weight + k dweight, and u + du * part,
   part = k * 2 half / its weight. It is u at the first and u + du at the last pixel. */
struct perspective_line {
    uint16 left;                /* x of the first pixel + EDGE_BIAS */
    int16 n;                    /* below 0: nothing to draw; 0: only left, u and v count */
    uint32 u, v;                /* 16.16 modulo 2^32 */
    int32 du, dv;               /* from the first to the last pixel; |du|, |dv| < 2^31 */
    uint32 weight;              /* below 2^31 */
    int32 dweight;
    uint32 half;                /* below 2^30 / n */
    /* Curves: the least weight with which a piece of so many pixels keeps to the tolerance. */
    int32 enough4, enough8, enough16, enough32;
};

/* Everything a perspective span needs: it draws the whole table. */
struct perspective_span {
    const struct perspective_line *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* MAP_PAGE */
    int32 longest;              /* curves: index of the longest piece; else log2 of pieces */
};

/* src68k/edge and src68k/span: contracts there. */
void perspective_lines(const struct perspective_plan *plan);
void level_lines(const struct perspective_plan *plan, struct scanline_step *steps);
void span_perspective_pieces(const struct perspective_span *span);
void span_perspective_curves(const struct perspective_span *span);

#endif
