/* Polygons in perspective by affine spans' mapper with no tolerance, the usual case: what their material and the frame
   decide is set once for many. */
#ifndef DEEP_H
#define DEEP_H

#include "drawing/material.h"
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

/* Sets what the frame and the renderer decide. Returns 0 if polygon_draw_inside draws all polygons: pixels of more than a
   byte, another form than the addx one, a rule is off, polygons are counted, or the pitch is not an int16. */
int32 deep_begin(struct deep *deep, struct renderer *renderer);

/* Sets what the material decides. Returns 0 if polygon_draw_inside draws its polygons: other mappers, no perspective, a
   tolerance, EDGES_SNAPPED, or rounded edges with CLIP_VERTICES. */
int32 deep_take(struct deep *deep, const struct material *material);

/* Sets the vertices of a polygon that is drawn whole. */
static inline void deep_set_vertices(struct deep *deep, const struct polygon *polygon)
{
    struct setup *s = &deep->s;

    s->given = s->vertices = polygon->vertices;
    s->count = polygon->count;
    if (!deep->takes)
        s->vertices = material_made(s->scratch->vertices, s->given, s->count, s->material);
}

/* As polygons_draw, for a material with perspective, from `polygons` to `end`. */
enum polygon_result deep_run(struct deep *deep, struct renderer *renderer, const struct polygon *polygons,
                             const struct polygon *end, const struct material *material);

/* Draws a polygon whose sides, box and, if is_sure, depth are found; edges too, or their plan's lefts is 0. */
enum polygon_result deep_rest(struct deep *deep, int32 is_sure);

#endif
