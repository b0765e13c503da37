/* The scanline table: what edges write and spans read, one entry a line. */
#ifndef SCANLINE_H
#define SCANLINE_H

#include "compiler.h"
#include "texture/map.h"

enum scanline_constants {
    /* Added to every x in the table. It keeps the integer half of a swapped x
       positive, so that its carry never reaches the fraction above it. */
    EDGE_BIAS = 16384,

    /* Of generated code: 4 bytes a pixel, FRAME_SIDE_MAX pixels, a return. At a multiple
       of the instruction cache's size its speed does not depend on chance. */
    CODE_BYTES = 4 * 1024 + 4,
    CACHE_BYTES = 256,

    /* What u and v of generated code begin with, in 1/65536 texel, so that no texel is left
       late: of up to FRAME_SIDE_MAX - 1 steps, each is up to 1/2 short by its rounding, and
       1/128 by its gradient's own error up to 256 texels a pixel. */
    GENERATED_BIAS = 520,

    /* The most pixels a line may have for the spans of short lines: what the
       instruction cache has room for. */
    SHORT_AFFINE = 18,
    SHORT_AFFINE_WRAP = 16,
    SHORT_AFFINE_ROW = 27,
    SHORT_GOURAUD = 54,
    SHORT_LIT = 13,
    SHORT_LIT_WRAP = 12,

    /* The fewest with which span_affine_copy is quicker than span_affine_row_short. */
    COPY_LEAST = 5,
    COPY_16_LEAST = 6,          /* the same of span_affine_16_copy and span_affine_16_row */

    /* In a lit line's shade: what the wraps of a falling v are taken from. */
    SHADE_FALLS = 0x3ff0000
};

/* One line of a polygon, and what is interpolated at its first pixel's centre, in
   the packing of its span routines (capitals integer, small letters fraction, one
   letter a byte). left stands beside u's fraction, so that one addition moves both:
     addx:  start0 = uu, start1 = Vv, start2 = v--U   (u, v modulo 256 texels)
     plain: start0 = uu, start1 = UU, start2 = VVvv   (16.16)                   */
struct scanline {
    uint16 start0;
    uint16 left;                /* x of the first pixel + EDGE_BIAS, up to 32768 */
    int16 last;                 /* of the last one + EDGE_BIAS; below left: none */
    uint16 start1;
    uint32 start2;
};

struct vertex;

/* One side of a section: the lines between two vertices of one polygon side. x moves
   by whole pixels a line; the error grows by part, and where it reaches 2^32, x moves
   one pixel more. With height 0 that is 32-bit fixed point. With a height h it is the
   integer quotient's remainder: error is in [2^32 - h, 2^32), part in [0, h). */
struct edge {
    int32 lines;                /* 1 or more */
    uint32 x;                   /* of the first line's first pixel + EDGE_BIAS */
    int32 whole;                /* floor(slope) */
    uint32 error, part;
    uint32 height;              /* what a carry takes from the error; 0: nothing */
    uint32 u, v;                /* left edges: at the first line's first pixel and ... */
    fix16 du, dv;               /* ... a line and `whole` pixels on; 16.16 modulo 2^32 */

    /* Where it comes from; no stepper reads this. */
    const struct vertex *upper, *lower;
    int32 top;                  /* the first line in the frame */
};

/* Everything a scanline stepper needs. */
struct edge_plan {
    struct scanline *lines;     /* the first line's entry */
    struct edge *left, *right;
    int32 lefts, rights;        /* how many of each; both cover the same lines */
    fix16 dudx, dvdx;           /* texels for the pixel that a carry adds */
};

/* Texels a pixel of one line. */
struct scanline_step {
    fix16 dudx, dvdx;
};

/* The way along an edge, for GRADIENTS_SCANLINE: where it crosses the lines. */
struct ramp {
    int32 lines;                /* 1 or more */
    fix16 x;                    /* pixels, without EDGE_BIAS; at the first line */
    uint32 u, v;                /* texels */
    fix16 dx, du, dv;           /* a line */
};

/* Everything edge_ramp needs. */
struct ramp_plan {
    struct scanline *lines;     /* the first line's entry; left and last are there */
    int32 count;                /* lines, 1 or more */
    struct ramp *left, *right;  /* both cover the lines; the routine uses them up */
    struct scanline_step *steps;        /* one a line */
    int32 truncated;            /* u, v where the left side crosses the line */
    int32 packed;               /* starts of the addx form */
};

/* Everything a scissor routine needs. */
struct scissor_plan {
    struct scanline *lines;
    int32 count;                /* lines, 1 or more */
    int32 width;                /* of the frame, pixels */
    fix16 dudx, dvdx;           /* texels a pixel */
};

/* Everything edge_hold needs. Each range has room for a line of the table. */
struct hold_plan {
    struct scanline *lines;     /* plain form */
    int32 count;                /* lines, 1 or more */
    fix16 dudx, dvdx;           /* texels a pixel; made smaller where they must be */
    fix16 u_low, u_high;        /* where u of every pixel shall lie, both included */
    fix16 v_low, v_high;
};

/* Everything edge_shade needs: levels of a light table, 16.16 in multiples of 4 units. */
struct shade_plan {
    const struct scanline *lines;       /* left and last are there */
    int32 count;                /* lines, 1 or more */
    uint32 *shades;             /* one a line, as span_lit_gouraud begins */
    uint32 added;               /* to each: SHADE_FALLS where dvdx is negative modulo 256,
                                   and the light table's place in its page */
    uint32 shade;               /* where left is 0 on the first line; modulo 2^32 */
    fix16 dcdx, dcdy;           /* levels a pixel, a line; dcdx is made smaller where it
                                   must be */
    fix16 low, high;            /* the least and greatest of any pixel */
    int32 inside;               /* all pixels have such: nothing to be done for it */
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
    const struct column_layout *columns;        /* column layout */
    const struct scanline_step *steps;          /* scanline: instead of dudx, dvdx */
    void *code;                 /* generated: room for CODE_BYTES */
    const uint8 *light;         /* lit: the level's row; lit Gouraud: the light table */
    const uint32 *shades;       /* lit Gouraud: struct shade_plan's */
    fix16 dcdx;                 /* lit Gouraud: levels a pixel */
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
void edge_ramp(const struct ramp_plan *plan);
void edge_shade(struct shade_plan *plan);
void edge_hold(struct hold_plan *plan);
void scissor_addx(const struct scissor_plan *plan);
void scissor_plain(const struct scissor_plan *plan);
void scissor_flat(const struct scissor_plan *plan);

#endif
