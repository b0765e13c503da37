/* Polygons in perspective by affine spans' mapper with no tolerance, the usual case: what their material and the frame
   decide is set once for many. */
#ifndef DEEP_H
#define DEEP_H

#include "perspective/far.h"

enum {
    /* Pixels of the widest polygon whose straight lines with a tilt are drawn from their far ends. */
    PERSPECTIVE_TILT_LEAST = 48,
    DEEP_CONSTANT = -1                  /* of deep_draw: w is constant, and nothing is drawn */
};

/* How a material's polygons are drawn. */
struct deep {
    struct setup s;                     /* of the last polygon */
    int32 exact;                        /* 1: exact edges */
    int32 takes;                        /* 1: material_vertices returns the given ones */
    int32 saved;                        /* cycles by columns, a pixel */
    uint8 *row;                         /* the frame's first, at pixel -EDGE_BIAS */
    uint32 right;                       /* the frame's width, pixels, 16.16; 0: never from the far ends of lines */
    struct depth depth;
    struct far_way way;
    struct perspective_plan plan;
};

/* Draws a polygon whose vertices are set as material_vertices makes them. Returns enum polygon_result or DEEP_CONSTANT.
   src68k/polygon: contract there. */
int32 deep_draw(struct deep *deep);

/* Draws a polygon whose sides, box and, if is_sure, depth are found; edges too, or their plan's lefts is 0. */
enum polygon_result deep_rest(struct deep *deep, int32 is_sure);

#endif
