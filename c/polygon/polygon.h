/* A convex polygon on the screen, its material and the ways to draw it. */
#ifndef POLYGON_H
#define POLYGON_H

#include "compiler.h"
#include "limits.h"
#include "polygon/mapper_list.h"
#include "polygon/span_list.h"
#include "polygon/vertex.h"
#include "span/perspective.h"
#include "texture/map.h"

/* Accuracy of the picture: each setting from cheap to exact. */
enum edges {
    EDGES_INTEGER,              /* vertices cut to whole pixels */
    EDGES_SUBPIXEL,             /* slopes in 16.16, started at the first line: neighbours
                                   leave no gap, but both may draw a pixel beside a sliver */
    EDGES_SNAPPED,              /* vertices rounded to 1/16 pixel, edges exact for these; triangles
                                   in range are set up in 32 bits (c/triangle), others as with
                                   EDGES_EXACT */
    EDGES_EXACT,                /* integer quotient and remainder */
    EDGES_KINDS
};

/* Edges by integer quotient and remainder. */
#define EDGES_ARE_EXACT(edges) ((edges) >= EDGES_SNAPPED)

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

/* How a polygon is clipped to the frame. */
enum clip {
    CLIP_SCISSOR,               /* lines are cut, edges begin at the frame's top line */
    CLIP_VERTICES,              /* the outline is clipped; lines are cut if edges are exact */
    CLIP_KINDS
};

/* How u and v follow the depth along a line. */
enum perspective {
    PERSPECTIVE_NONE,           /* not at all: affine */
    PERSPECTIVE_EVERY16,        /* exact at both ends of pieces, 16 pixels as a rule, affine between: within a pixel */
    PERSPECTIVE_EVERY8,         /* of 8 pixels as a rule: within half a pixel */
    PERSPECTIVE_PIXEL,          /* each pixel within 1/32 texel */
    PERSPECTIVE_FINE,           /* each pixel within 1/128 texel */
    PERSPECTIVE_KINDS
};

/* Forms of spans and edges: the same picture at different speeds. */
enum form { FORM_ADDX, FORM_SWAP, FORM_C };

enum polygon_result {
    POLYGON_DRAWN,
    POLYGON_EMPTY,              /* covers no pixel centre of the frame */
    POLYGON_FEW,                /* fewer than 3 or more than 64 vertices */
    POLYGON_OUTSIDE_RANGE,      /* a vertex POLYGON_FAR or more away */
    POLYGON_NO_TRIANGLE,        /* GRADIENTS_POLYGON is for triangles */
    POLYGON_WRONG_MAP,          /* the mapper cannot draw this map or frame */
    POLYGON_REFUSED             /* by the texture unit, which has the reason */
};

struct frame {
    uint8 *pixels;              /* row 0 on top */
    int32 width, height, pitch; /* pixels, pixels, bytes */
    int32 pixel_bytes;          /* 1, 2 or 4, at a multiple of them */
};

/* How a polygon's pixels are made. */
enum mapper {
#define MAPPER(kind, name, layout, bytes, is, span, span_16, span_32) MAPPER_##kind,
    MAPPER_LIST(MAPPER)
#undef MAPPER
    MAPPER_KINDS
};

enum mapper_trait {
    MAPPER_LIGHTS = 1,          /* it has a light table */
    MAPPER_PLANE = 2,           /* GRADIENTS_PLANE and START_SUBTEXEL only */
    MAPPER_UNIT = 4,            /* a texture unit draws it */
    MAPPER_BY_VERTICES = 8,     /* the vertices may allow a cheaper span */
    MAPPER_PERSPECTIVE = 16     /* it draws perspective */
};

/* Span routines; pixels are counted by them. A polygon with perspective that is not level is drawn by
   PIECES, CURVES, RECIPROCAL or CUBIC, and lit by LIGHT or LIGHT_GOURAUD, which count its pixels
   once more. */
enum span_kind {
#define SPAN(kind, name, lines) SPAN_##kind,
#define OTHER(kind, name) SPAN_##kind,
    SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER
    SPAN_KINDS,
    SPAN_PERSPECTIVE = SPAN_KINDS       /* one with perspective, not yet decided */
};

enum rule {
#define RULE(rule, name) RULE_##rule,
    RULE_LIST(RULE)
#undef RULE
    RULES
};

struct draw_counts {
    uint32 polygons;            /* that reached a span routine */
    uint32 hidden, hidden_pixels;       /* with a cover: polygons hidden whole, pixels that are not drawn */
    uint32 unsure;              /* drawn affine, as depth varies too much for planes of 32 bits */
    uint32 pixels[SPAN_KINDS];
    uint32 rules[RULES];        /* polygons to which each applied */
};

/* Values of a polygon's vertices that are drawn as planes over the screen. */
enum planar_values {
    PLANAR_TEXELS = 1,          /* s and t */
    PLANAR_DEPTHS = 2,          /* 1/w, s/w and t/w */
    PLANAR_SHADES = 4,          /* shade */
    PLANAR_COLOURS = 8,         /* R, G, B and A of shade */
    PLANAR_ALL = 15,
    PLANAR_ROUGH = 16,          /* those that are checked: PLANAR_SHADES may be a shade off */
    PLANAR_SHADE = 65536        /* a shade, 16.16 */
};

/* A convex polygon, either winding. */
struct polygon {
    const struct vertex *vertices;
    const struct vertex *second;        /* s, t and w of the same corners for Glide's second unit
                                           if it has separate coordinates, else 0 */
    int32 count;
    uint32 planar;              /* enum planar_values that the caller knows to be on planes:
                                   these are not checked if there are more than three vertices */
};

/* Sets a polygon without second coordinates. */
static inline void polygon_set(struct polygon *polygon, const struct vertex *vertices, int32 count,
                               uint32 planar)
{
    polygon->vertices = vertices;
    polygon->second = 0;
    polygon->count = count;
    polygon->planar = planar;
}

struct coverage;
struct material;
struct scratch;

/* Settings and memory for drawing polygons. The caller owns it: renderers in one program do not
   affect each other. */
struct renderer {
    const struct frame *frame;
    enum form form;
    uint32 off;                 /* bit n: rule n is off; exact rules do not change the picture */
    struct draw_counts *counts; /* one a material, or 0: nothing is counted */
    int32 only_counts;          /* 1: polygons are counted, and not drawn */
    struct scratch *scratch;    /* polygon/scratch.h; undefined between polygons */
    const uint16 *reciprocals;  /* tables of perspective: every16, every8; 0: divide instead */
    const struct triangle_tables *triangles;    /* triangle_tables_make; 0: EDGES_SNAPPED set up
                                                   as exact */
    struct coverage *coverage;  /* coverage_draw: what is drawn already; others do not read it */
};

/* Draws or counts a polygon. */
typedef enum polygon_result polygon_routine(struct renderer *renderer,
                                            const struct polygon *polygon,
                                            const struct material *material);

/* The material of a polygon. */
struct material {
    uint8 mapper, edges, gradients, start, clip;
    uint8 perspective;          /* MAPPER_PERSPECTIVE, GRADIENTS_PLANE, START_SUBTEXEL */
    uint8 whole;                /* MAPPER_AFFINE, GRADIENTS_PLANE: the plane of texture units to
                                   the last bit. u's lowest counts even where v wraps in a line,
                                   for 2 cycles a pixel there */
    uint8 levels;               /* polygon_draw_mipmapped: of its map, beyond the map itself */
    uint16 level_at;            /* from it to the material of the first level, in the array that it is in */
    uint16 number;              /* its index in the renderer's counts */
    fix16 tolerance;            /* texels that u and v may be off for cheaper perspective, in
                                   addition to the setting's bound: 0 to TOLERANCE_MAX */
    uint32 colour;              /* MAPPER_FLAT: the pixel */
    const struct map *map;      /* in the layout of the mapper */
    const struct map *light;    /* MAPPER_LIGHTS: a MAP_LIGHT */
    polygon_routine *draw;      /* called by meshes and scenes */
    struct n64_unit *unit;      /* MAPPER_N64 */
    struct glide_pipe *pipe;    /* MAPPER_GLIDE. 40 bytes: an index is multiplied by an addition
                                   and two shifts */
};

/* Draws with every mapper except MAPPER_N64 and MAPPER_GLIDE. With GRADIENTS_PLANE, a polygon of
   more than three vertices whose values are not on a plane (drawing/parts/fan.c has the tolerance) is drawn as a
   fan of triangles from its first vertex, so that the picture has the values of every vertex. */
polygon_routine polygon_draw;

/* The same with mip maps. The material's `levels` materials from level_at on differ from it in their maps alone: each
   has half the sides of the one before. Draws with the nearest to a texel a pixel. */
polygon_routine polygon_draw_mipmapped;

/* Draws polygons of one material in their order, with the picture of polygon_draw; snapped ones (EDGES_SNAPPED,
   renderer->triangles) in batches, for less. Returns POLYGON_DRAWN, or why one of them was refused. */
enum polygon_result polygons_draw(struct renderer *renderer, const struct polygon *polygons,
                                  int32 count, const struct material *material);

#endif
