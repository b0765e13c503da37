/* A convex polygon on the screen and what it is drawn with. */
#ifndef POLYGON_H
#define POLYGON_H

#include "compiler.h"
#include "scene/scene_file.h"

/* x, y: pixels, pixel centres at integers, |x|, |y| < POLYGON_FAR.
   s, t: 0 to 256 along the longer side of the map, whatever its size; any value
   where the map repeats, |s|, |t| < POLYGON_FAR. shade: 0 to 255. All 16.16. */
struct vertex {
    fix16 x, y, s, t, shade;
};

enum polygon_constants {
    POLYGON_FAR = 16384         /* pixels: differences stay inside 16.16 */
};

/* How near the picture comes to the exact one, from cheap to exact. */
enum edges {
    EDGES_INTEGER,              /* vertices cut to whole pixels */
    EDGES_SUBPIXEL,             /* slopes in 16.16, started at the first line */
    EDGES_EXACT,                /* integer quotient and remainder */
    EDGES_KINDS
};

enum gradients {
    GRADIENTS_SCANLINE,         /* two divides a scanline */
    GRADIENTS_POLYGON,          /* two divides, by the longest scanline: triangles */
    GRADIENTS_PLANE,            /* from three vertices, through 64 bits */
    GRADIENTS_KINDS
};

enum start {
    START_TRUNCATED,            /* u, v where the edge crosses the line */
    START_SUBTEXEL,             /* u, v at the first pixel's centre */
    START_KINDS
};

/* Spans and edges in swapped form and plain form: same picture, other speed. */
enum form { FORM_ADDX, FORM_SWAP, FORM_C };

enum polygon_result {
    POLYGON_DRAWN,
    POLYGON_EMPTY,              /* covers no pixel centre of the frame */
    POLYGON_FEW,                /* fewer than 3 or more than 64 vertices */
    POLYGON_OUTSIDE_RANGE,      /* a vertex POLYGON_FAR or more away */
    POLYGON_NO_TRIANGLE         /* GRADIENTS_POLYGON is for triangles */
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
    uint8 edges, gradients, start;
};

/* Draws a convex polygon, either winding. counts may be 0; counting takes time. */
enum polygon_result polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                 int32 count, const struct material *material,
                                 enum form form, struct draw_counts *counts);

#endif
