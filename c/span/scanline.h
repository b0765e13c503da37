/* The scanline table: what edges write and spans read, one entry a line. */
#ifndef SCANLINE_H
#define SCANLINE_H

#include "compiler.h"

enum scanline_constants {
    /* Added to every x in the table. It keeps the integer half of a swapped x
       positive, so that its carry never reaches the fraction above it. */
    EDGE_BIAS = 16384
};

/* Texture coordinates at the first pixel's centre, in the form's packing
   (capitals integer, small letters fraction, one letter a byte):
     addx: start0 = uuVv, start1 = v--U
     swap: start0 = UUuu, start1 = VVvv   (plain 16.16)                       */
struct scanline {
    int16 count;                /* pixels; 0 to -32767: none */
    uint16 left;                /* x of the first pixel + EDGE_BIAS */
    uint32 start0, start1;
};

/* One side of a section: the lines between two vertices of one polygon side. */
struct edge {
    int32 lines;                /* 1 or more */
    fix16 x;                    /* at the first line, rounded up to pixels by the
                                   stepper; plain 16.16, EDGE_BIAS included */
    fix16 slope;                /* pixels a line */
    uint32 u, v;                /* texels at the first line's first pixel, left
                                   edges only; 16.16 modulo 2^32 */
};

/* Everything a scanline stepper needs. */
struct edge_plan {
    struct scanline *lines;     /* the first line's entry */
    const struct edge *left;
    const struct edge *right;
    int32 lefts, rights;        /* how many of each; both cover the same lines */
    fix16 dudx, dvdx;           /* texels a pixel and ... */
    fix16 dudy, dvdy;           /* ... a line, modulo 2^32 */
};

/* Everything a scissor routine needs. */
struct scissor_plan {
    struct scanline *lines;
    int32 count;                /* lines, 1 or more */
    int32 width;                /* of the frame, pixels */
    fix16 dudx, dvdx;           /* texels a pixel */
};

/* Everything a span routine needs: it draws the whole table. */
struct span_plan {
    const struct scanline *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* 256x256, at a multiple of 65,536 */
    fix16 dudx, dvdx;           /* texels a pixel */
    uint32 colour;              /* flat: the pixel, in the low byte */
};

/* src68k/edge and src68k/span: contracts there. */
void edge_addx(const struct edge_plan *plan);
void edge_swap(const struct edge_plan *plan);
void edge_flat(const struct edge_plan *plan);
void scissor_addx(const struct scissor_plan *plan);
void scissor_swap(const struct scissor_plan *plan);
void scissor_flat(const struct scissor_plan *plan);
void span_fill(const struct span_plan *plan);
void span_affine_addx(const struct span_plan *plan);
void span_affine_addx_wrap(const struct span_plan *plan);
void span_affine_swap(const struct span_plan *plan);

/* c/span: the same work as span_affine_swap in plain C. */
void span_affine_c(const struct span_plan *plan);

#endif
