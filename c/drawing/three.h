/* Triangles by flat, Gouraud's or affine spans without perspective, the usual case: rules that such
   triangles do not need would take a quarter of a small one's time. */
#ifndef THREE_H
#define THREE_H

#include "polygon/kind.h"
#include "polygon/setup.h"

/* The spans that three_draw calls itself. */
enum three_way { THREE_FLAT, THREE_SHADES, THREE_TEXELS, THREE_REST, THREE_WIDE /* texels of 16 or 32 bits */ };

/* Where steps and starts are from. */
enum three_starts {
    THREE_PLANE,                /* the plane */
    THREE_LONGEST,              /* the longest scanline and the edges' crossings */
    THREE_STARTS,               /* three_starts */
    THREE_WHOLE                 /* the plane, to the last bit */
};

/* How vertices are made from given ones. */
enum three_vertices {
    THREE_GIVEN,                /* they are the same */
    THREE_CUT,                  /* x and y by the mask */
    THREE_SHADED,               /* shade_vertices */
    THREE_MADE                  /* material_made */
};

/* How a material's triangles are drawn. */
struct three {
    struct setup s;             /* of the last triangle */
    int32 chain;                /* enum chain, or OUTLINE_ALONE */
    void (*edges)(void);        /* edge_exact_across or edge_rounded_across */
    int32 way;                  /* enum three_way */
    int32 vertices;             /* enum three_vertices */
    uint32 mask;                /* of x and y */
    int32 starts;               /* enum three_starts */
    void (*lines)(void);        /* makes lines in the form of the way's spans */
    uint8 *row;                 /* the frame's first, at pixel -EDGE_BIAS */
    uint32 right;               /* the frame's width, pixels, 16.16 */
    uint32 steep;               /* THREE_SHADES: steps from here on may need clamp_lines */
};

/* Sets the routine for the lines of the kind of span. */
static inline void three_set_lines(struct three *three)
{
    const int32 exact = EDGES_ARE_EXACT(three->s.material->edges);

    three->lines = line_routines[kind_lines[three->s.kind]].lines[exact];
}

/* Sets what the frame and the material decide. Returns 0 if polygon_draw_inside draws the material's
   triangles: EDGES_SNAPPED, CLIP_VERTICES, GRADIENTS_SCANLINE, other spans and forms, a rule is off, polygons are
   counted, or the pitch is not an int16. */
int32 three_set(struct three *three, const struct renderer *renderer, const struct material *material);

/* Draws a triangle of the plan's material. */
enum polygon_result three_polygon(struct three *three, const struct vertex *vertices);

/* MAPPER_GOURAUD: the same; made: the given vertices from material_vertices. */
enum polygon_result three_shaded(struct three *three, const struct vertex *given, const struct vertex *made);

/* The same, with vertices from material_vertices. src68k/polygon: contracts there. */
enum polygon_result three_draw(struct three *three, const struct vertex *vertices);

/* Draws polygons up to one that is not a triangle, or is out of range, or has three equal shades; returns its address or `end`. Not for THREE_MADE. */
const struct polygon *three_run(struct three *three, const struct polygon *polygons,
                                const struct polygon *end);

/* THREE_LONGEST: finds steps and starts; a0 is the plan. */
void three_longest(void);

/* Finds steps and starts that the plane alone, or the longest scanline and the crossings, do not give. */
void three_starts(struct three *three);

/* Draws a triangle whose sides, box, edges and steps are found. */
void three_rest(struct three *three);

#endif
