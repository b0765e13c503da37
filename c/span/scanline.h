/* The scanline table, written by edges and read by spans: one entry a line. */
#ifndef SCANLINE_H
#define SCANLINE_H

#include "compiler.h"
#include "texture/map.h"

enum scanline_constants {
    /* Added to every x in the table. It keeps the integer half of a swapped x
       positive, so that its carry never reaches the fraction above it. */
    EDGE_BIAS = 16384,

    /* Size of generated code: 4 bytes a pixel for FRAME_SIDE_MAX pixels, and a return. It starts at
       a multiple of the instruction cache's size, so that its speed does not depend on chance. */
    CODE_BYTES = 4 * 1024 + 4,
    CACHE_BYTES = 256,

    /* The fraction of u and v at which generated code begins, in 1/65536 texel, so that no texel
       begins late: each of up to FRAME_SIDE_MAX - 1 steps is up to 1/2 short by its rounding, and
       1/128 by its gradient's error, up to 256 texels a pixel. */
    GENERATED_BIAS = 520,

    /* The longest lines, in pixels, that the spans of short lines draw: their code must fit the
       instruction cache. */
    SHORT_AFFINE = 18,
    SHORT_AFFINE_WRAP = 16,
    SHORT_AFFINE_ROW = 27,
    SHORT_GOURAUD = 54,
    SHORT_LIT = 13,
    SHORT_LIT_WRAP = 12,

    /* The fewest pixels with which span_affine_copy is faster than span_affine_row_short. */
    COPY_LEAST = 5,
    COPY_16_LEAST = 6,          /* the same for span_affine_16_copy and span_affine_16_row */

    /* Added to a lit line's shade where v falls: the bits from which wraps of v borrow. */
    SHADE_FALLS = 0x3ff0000,
    /* The same for span_light_gouraud where the level falls: it carries into the fraction. */
    LEVEL_FALLS = 0x10000
};

/* One line of a polygon, with the interpolants at its first pixel's centre, packed for its span
   routines (capitals integer, small letters fraction, one letter a byte). left is next to u's
   fraction, so that one addition steps both:
     addx:  start0 = uu, start1 = Vv, start2 = v--U   (u, v modulo 256 texels)
     plain: start0 = uu, start1 = UU, start2 = VVvv   (16.16)                   */
struct scanline {
    uint16 start0;
    uint16 left;                /* x of the first pixel + EDGE_BIAS, up to 32768 */
    int16 last;                 /* x of the last one + EDGE_BIAS; below left: no pixels */
    uint16 start1;
    uint32 start2;
};

struct vertex;

/* An edge: the lines between two vertices on one side of a polygon. Each line moves x by `whole`
   pixels and adds part to error; where error reaches 2^32, x moves one pixel more. With height 0
   that is 32-bit fixed point. With a height h, x is an exact integer quotient and error its
   remainder: error is in [2^32 - h, 2^32), part in [0, h). */
struct edge {
    int32 top;                  /* the first line in the frame; no stepper reads it */
    int32 lines;                /* 1 or more */
    const struct vertex *upper, *lower;         /* no stepper reads these */
    uint32 height;              /* subtracted from error after a carry; 0 for fixed point */
    uint32 error;
    int32 whole;                /* floor(slope); with one line, whole and part may be 0 */
    uint32 part;
    uint32 x;                   /* of the first line's first pixel + EDGE_BIAS */
    uint32 u, v;                /* left edges: at the first line's first pixel; */
    fix16 du, dv;               /* steps of a line and `whole` pixels; 16.16 modulo 2^32 */
};

/* Everything a scanline stepper needs. */
struct edge_plan {
    struct scanline *lines;     /* the first line's entry */
    struct edge *left, *right;
    int32 lefts, rights;        /* number of each; both cover the same lines */
    fix16 dudx, dvdx;           /* texels a pixel, added at a carry */
};

/* True if a step is 0, and if it is small enough for the spans that step only u or v: 62 texels a
   pixel, for 1,024 pixels. Both modulo 256 texels, as the map repeats. */
#define STEP_IS_STILL(step) (!((uint32)(step) << 8))
#define STEP_IS_SLOW(step) (((uint32)(step) << 8) + ((uint32)62 << 24) <= (uint32)124 << 24)

/* Texels a pixel of one line. */
struct scanline_step {
    fix16 dudx, dvdx;
};

/* x, u and v where an edge crosses the lines, for GRADIENTS_SCANLINE. */
struct ramp {
    int32 lines;                /* 1 or more */
    fix16 x;                    /* pixels, without EDGE_BIAS; at the first line */
    uint32 u, v;                /* texels */
    fix16 dx, du, dv;           /* a line */
};

/* Everything edge_ramp needs. */
struct ramp_plan {
    struct scanline *lines;     /* the first line's entry; left and last are set */
    int32 count;                /* lines, 1 or more */
    struct ramp *left, *right;  /* both cover the lines; the routine changes them */
    struct scanline_step *steps;        /* one a line */
    int32 truncated;            /* 1: u, v start where the left side crosses the line */
    int32 packed;               /* 1: starts in the addx form */
};

/* Everything a scissor routine needs. */
struct scissor_plan {
    struct scanline *lines;
    int32 count;                /* lines, 1 or more */
    int32 width;                /* of the frame, pixels */
    fix16 dudx, dvdx;           /* texels a pixel */
};

/* Everything edge_clamp needs. Each range has room for a line of the table. */
struct clamp_plan {
    struct scanline *lines;     /* plain form */
    int32 count;                /* lines, 1 or more */
    fix16 dudx, dvdx;           /* texels a pixel; reduced if a line would not fit its range */
    fix16 u_low, u_high;        /* the range for u of every pixel, both included */
    fix16 v_low, v_high;
};

/* Everything edge_opaque needs. */
struct opaque_plan {
    struct scanline *lines;     /* addx form */
    int32 count;                /* lines, 1 or more */
    fix16 dudx;                 /* texels a pixel, -62 to 62 modulo 256 */
    const struct map_row *rows;
    int32 width, height;        /* of the map */
};

/* Everything edge_shade needs: levels of a light table, 16.16 in multiples of 4 units. */
struct shade_plan {
    const struct scanline *lines;       /* left and last are set */
    int32 count;                /* lines, 1 or more */
    uint32 *shades;             /* one a line, in span_lit_gouraud's packing */
    uint32 added;               /* to each: the light table's offset in its page, and SHADE_FALLS
                                   where dvdx is negative modulo 256 or, for span_light_gouraud,
                                   LEVEL_FALLS where dcdx is negative */
    uint32 shade;               /* where left is 0 on the first line; modulo 2^32 */
    fix16 dcdx, dcdy;           /* levels a pixel, a line; dcdx is reduced if a line would not
                                   fit the range */
    fix16 low, high;            /* the range for every pixel, both included */
    int32 inside;               /* 1: all pixels are in the range without any change */
};

/* Everything a span routine needs: it draws the whole table. */
struct span_plan {
    const struct scanline *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* texel (0, 0) */
    fix16 dudx, dvdx;           /* texels a pixel; Gouraud: dudx is shades a pixel */
    uint32 colour;              /* flat: the pixel, in the low byte or word, or all of it */
    int32 map_width, map_height;                /* arbitrary size: texels */
    const struct column_layout *columns;        /* columns */
    const struct scanline_step *steps;          /* scanline: replace dudx, dvdx */
    void *code;                 /* generated: room for CODE_BYTES */
    const uint8 *light;         /* lit, light: the level's row; lit and light Gouraud: the table */
    const uint32 *shades;       /* lit and light Gouraud: struct shade_plan's */
    fix16 dcdx;                 /* lit and light Gouraud: levels a pixel */
    int32 odd;                  /* dithered: the first line's y, modulo 2 */
};

/* src68k/edge: contracts there. polygon/kind.h declares the spans. */
void edge_flat(const struct edge_plan *plan);
void edge_flat_exact(const struct edge_plan *plan);
void edge_addx(const struct edge_plan *plan);
void edge_addx_exact(const struct edge_plan *plan);
void edge_plain(const struct edge_plan *plan);
void edge_plain_exact(const struct edge_plan *plan);
void edge_swap(const struct edge_plan *plan);
void lines_flat(void);
void lines_flat_exact(void);
void lines_addx(void);
void lines_addx_exact(void);
void lines_plain(void);
void lines_plain_exact(void);
void edge_ramp(const struct ramp_plan *plan);
void edge_shade(struct shade_plan *plan);
void edge_clamp(struct clamp_plan *plan);
void edge_opaque(const struct opaque_plan *plan);
void scissor_addx(const struct scissor_plan *plan);
void scissor_plain(const struct scissor_plan *plan);
void scissor_flat(const struct scissor_plan *plan);

#endif
