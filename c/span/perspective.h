/* Lines with perspective, written by perspective_lines and read by the perspective spans. */
#ifndef SPAN_PERSPECTIVE_H
#define SPAN_PERSPECTIVE_H

#include "math/math.h"
#include "span/scanline.h"

enum perspective_constants {
    /* log2 of a piece's pixels, where q does not grow slowly; for curves, of the longest piece's. */
    PERSPECTIVE_PIECE_EVERY16 = 4,
    PERSPECTIVE_PIECE_EVERY8 = 3,
    PERSPECTIVE_PIECE_PIXEL = 5,
    PERSPECTIVE_PIECE_FINE = 4,
    PERSPECTIVE_PIECE_EXACT = 6,        /* of straight pieces where q grows slowly */
    /* Bend of curves, rounded up: 64 log2(6 / (9 sqrt 3) / e). e is the error allowed, 1/32 or
       1/128 texel in units of 1/65536, less longest^2 / 8 + 8 units for rounding. */
    PERSPECTIVE_BEND_PIXEL = -785,
    PERSPECTIVE_BEND_FINE = -656,
    /* Units that straight pieces may be off where q grows so slowly that they do for curves: 1/32 or 1/128 texel, less
       2. Pieces of m pixels leave 4 m of them to what their lines are raised by and their ends and steps cut by. */
    PERSPECTIVE_STRAIGHT_PIXEL = 2046,
    PERSPECTIVE_STRAIGHT_FINE = 510,
    /* log2 of the parts of a texel that lines with straight pieces may be off if they are drawn as if their depth were
       constant; by reciprocals they are off by half of that. */
    PERSPECTIVE_EVEN_EVERY16 = 1,
    PERSPECTIVE_EVEN_EVERY8 = 2,
    PERSPECTIVE_EVEN_STEEP = 12,            /* q grows by less than 2^-12 of its least a pixel: a quick test */
    PERSPECTIVE_RECIPROCAL_LINES = 6,       /* from so many on level_reciprocal is cheaper than level_lines */
    /* Pixels of the highest box of columns whose u may have no step, and of the widest one of lines whose v has none: a
       chain of one register counts 255 wraps, and v moves by 64 texels a pixel at most, u by 128. */
    PERSPECTIVE_STILL_HEIGHT = 1000,
    PERSPECTIVE_STILL_WIDTH = 500,
    /* The error allowed for drawing a line as if its depth were constant, in 1/65536 texel, and the
       widest polygon with such lines. Their steps add a unit a pixel, two where u and v are chained, as they are in
       lines up to CHAIN wide; both together stay inside 1/32 or 1/128 texel. With straight pieces the depth must
       not change at all. */
    PERSPECTIVE_CHAIN_PIXEL = 510,
    PERSPECTIVE_LEVEL_PIXEL = 1020,
    PERSPECTIVE_LEVEL_FINE = 128,
    PERSPECTIVE_LEVEL_WIDTH = 380,          /* of FINE; of the others any frame's width */
    /* Units that steps of level_reciprocal may add, a unit or two a pixel included. Of the tolerance the error for
       the depth is left out, and 8 for rounding. */
    PERSPECTIVE_SPARE_PIXEL = 1020,
    PERSPECTIVE_SPARE_FINE = 376,
    PERSPECTIVE_SPARE_PIECES = 1 << 20,     /* all that fits */
    /* Which is cheaper, columns or lines: turning costs about 6,000 cycles, a column 440, or 1,000 if its depth is
       not the same all along it, and 19 a pixel, a line from 550 and 26 (EVERY16), 29, 67 or 87. */
    PERSPECTIVE_TURN = 6000,
    PERSPECTIVE_COLUMN = 440,
    PERSPECTIVE_COLUMN_TILTED = 1000,
    PERSPECTIVE_LINE = 550,
    PERSPECTIVE_SAVED_EVERY16 = 7,
    PERSPECTIVE_SAVED_EVERY8 = 10,
    PERSPECTIVE_SAVED_PIXEL = 48,
    PERSPECTIVE_SAVED_FINE = 68,
    /* Units by which lines are raised to make up for rounding. A fraction of the way from end to
       end loses 3; ends of pieces of m pixels lose m - 1, and the steps of the last piece m; curves
       are rounded by longest^2 / 8 + 8. */
    PERSPECTIVE_RAISE_EVERY16 = 34,
    PERSPECTIVE_RAISE_EVERY8 = 18,
    PERSPECTIVE_RAISE_PIXEL = 139,
    PERSPECTIVE_RAISE_FINE = 43
};

/* A value over the screen: at pixel (i, j), and its steps to the next pixel and line. */
struct screen_plane {
    struct number64 at, dx, dy;
};

/* Everything perspective_lines needs. With w0 the least w of the polygon, q is w0 / w, 1.0
   being 2^62; u is its base + s / q.hi, v is its base + t / q.hi, 16.16. Rounded edges may be a
   little outside the polygon: values are kept within the limits there. */
struct perspective_plan {
    struct scanline *lines;             /* left and last are read */
    int32 count;                        /* lines, 1 or more */
    struct screen_plane q, s, t;        /* at pixel (left, the first line) */
    int32 left;                         /* no pixel of the table is left of this */
    int32 q_low, q_high;                /* least and greatest q.hi at the vertices; above 0 */
    int32 gentle;                       /* 1: q.dx, q.dy, s.dx, t.dx are below 2^30 units of q.hi */
    fix16 u, u_low, u_high;             /* the base, a unit above a texel; range of u - base */
    fix16 v, v_low, v_high;
    int32 tilt;                         /* level_lines: q.hi's growth a pixel, 24.8; 0: none */
    int32 chained;                      /* level_lines: 1 if spans chain u and v, whose wraps change u */
    int32 width;                        /* level_reciprocal: pixels from left on in which all lines are; */
    int32 spare;                        /* units that C's steps may add over the width */
    int32 steep;                        /* lines_bend: the magnitude of q.hi's growth a pixel, rounded up */
    int32 bend;                         /* curves: PERSPECTIVE_BEND_...; else 0 */
    struct perspective_line *to;
    uint8 *row;                         /* level_draw: pixel -EDGE_BIAS of the first line; */
    int32 pitch;                        /* bytes from line to line or, if columns are drawn, from pixel to pixel; */
    const uint8 *map;                   /* MAP_PAGE */
};

/* One line of n + 1 pixels. Pixel k has the weight weight + k dweight and shows u + du * part, with
   part = k * 2 half / its weight: u at the first pixel and u + du at the last one. */
struct perspective_line {
    uint16 left;                /* x of the first pixel + EDGE_BIAS */
    int16 n;                    /* below 0: nothing to draw; 0: only left, u and v are set */
    uint32 u, v;                /* 16.16 modulo 2^32 */
    int32 du, dv;               /* from the first to the last pixel; |du|, |dv| < 2^31 */
    uint32 weight;              /* below 2^31 */
    int32 dweight;
    uint32 half;                /* below 2^30 / n */
    /* Curves: the least weight at which a piece of so many pixels is within the tolerance. */
    int32 enough4, enough8, enough16, enough32;
};

/* Everything a perspective span needs: it draws the whole table. */
struct perspective_span {
    const struct perspective_line *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const void *map;            /* MAP_PAGE */
    int32 longest;              /* log2 of a piece's pixels; curves: of the longest piece's */
};

/* src68k/edge and src68k/span: contracts there. */
void perspective_lines(const struct perspective_plan *plan);
int32 lines_bend(const struct perspective_plan *plan, int32 width);
void level_lines(const struct perspective_plan *plan, struct scanline_step *steps);
int32 level_reciprocal(const struct perspective_plan *plan, struct scanline_step *steps);
int32 level_draw(const struct perspective_plan *plan);
int32 level_draw_upright(const struct perspective_plan *plan);
void span_affine_upright(const struct span_plan *plan);
void span_affine_level(const struct span_plan *plan);
void span_affine_level_upright(const struct span_plan *plan);
void span_affine_16_scanline(const struct span_plan *plan);
void span_affine_16_level(const struct span_plan *plan);
void span_affine_32_scanline(const struct span_plan *plan);
void span_affine_32_level(const struct span_plan *plan);
void span_perspective_pieces(const struct perspective_span *span);
void span_perspective_pieces_16(const struct perspective_span *span);
void span_perspective_pieces_32(const struct perspective_span *span);
void span_perspective_curves(const struct perspective_span *span);
void span_perspective_curves_16(const struct perspective_span *span);
void span_perspective_curves_32(const struct perspective_span *span);

#endif
