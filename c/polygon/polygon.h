/* A convex polygon on the screen and what it is drawn with. */
#ifndef POLYGON_H
#define POLYGON_H

#include "compiler.h"
#include "scene/scene_file.h"

/* x, y: pixels, pixel centres at integers, |x|, |y| < POLYGON_FAR.
   s, t: texels of a 256x256 map, any value: the map repeats. All 16.16. */
struct vertex {
    fix16 x, y, s, t;
};

enum polygon_constants {
    POLYGON_FAR = 16384         /* pixels: differences stay inside 16.16 */
};

/* Spans and edges in swapped form and plain form: same picture, other speed. */
enum form { FORM_ADDX, FORM_SWAP, FORM_C };

enum polygon_result {
    POLYGON_DRAWN,
    POLYGON_EMPTY,              /* covers no pixel centre of the frame */
    POLYGON_FEW,                /* fewer than 3 or more than 64 vertices */
    POLYGON_OUTSIDE_RANGE       /* a vertex POLYGON_FAR or more away */
};

struct frame {
    uint8 *pixels;              /* chunky, row 0 on top */
    int32 width, height, pitch; /* pixels, pixels, bytes */
};

/* Which routines drew, counted where it is asked for. */
enum span_kind {
    SPAN_FILL, SPAN_AFFINE_ADDX, SPAN_AFFINE_ADDX_WRAP, SPAN_AFFINE_SWAP, SPAN_AFFINE_C,
    SPAN_KINDS
};

struct draw_counts {
    uint32 polygons;            /* that reached a span routine */
    uint32 pixels[SPAN_KINDS];
};

struct material {
    const uint8 *map;           /* 256x256, at a multiple of 65,536; 0: flat */
    uint32 colour;              /* of a flat one: palette index */
};

/* Draws a convex polygon, either winding. counts may be 0; counting takes time. */
enum polygon_result polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                 int32 count, const struct material *material,
                                 enum form form, struct draw_counts *counts);

#endif
