/* A convex polygon on the screen, its material and the ways to draw it. */
#ifndef POLYGON_H
#define POLYGON_H

#include "compiler.h"
#include "limits.h"
#include "polygon/vertex.h"
#include "span/logarithm.h"
#include "texture/map.h"

/* Accuracy of the picture: each setting from cheap to exact. */
enum edges {
    EDGES_INTEGER,              /* vertices cut to whole pixels */
    EDGES_SUBPIXEL,             /* slopes in 16.16, started at the first line: neighbours
                                   leave no gap, but a pixel beside a sliver may be both's */
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

/* How a polygon is clipped to the frame. */
enum clip {
    CLIP_SCISSOR,               /* lines are cut, edges begin at the frame's top line */
    CLIP_VERTICES,              /* the polygon is, before it has edges; exact ones: lines */
    CLIP_KINDS
};

/* How u and v follow the depth along a line. */
enum perspective {
    PERSPECTIVE_NONE,           /* not at all: affine */
    PERSPECTIVE_EVERY16,        /* right at both ends of pieces of 16 pixels, affine between */
    PERSPECTIVE_EVERY8,         /* of 8 pixels */
    PERSPECTIVE_PIXEL,          /* each pixel within 1/32 below and 1/16 texel above */
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
    POLYGON_REFUSED             /* by the texture engine's unit: it says why */
};

struct frame {
    uint8 *pixels;              /* row 0 on top */
    int32 width, height, pitch; /* pixels, pixels, bytes */
    int32 pixel_bytes;          /* 1, 2 or 4, at a multiple of them */
};

/* How a polygon's pixels are made. */
enum mapper {
    MAPPER_FLAT,
    MAPPER_GOURAUD,             /* shade is the pixel */
    MAPPER_AFFINE,              /* MAP_PAGE; 16- and 32-bit frames too */
    MAPPER_ARBITRARY,           /* MAP_LINEAR; s, t inside the map */
    MAPPER_TILED,               /* MAP_TILED */
    MAPPER_COLUMNS,             /* MAP_COLUMNS; 16-bit frames too */
    MAPPER_GENERATED,           /* MAP_MARGINS: code written for the polygon's steps; affine
                                   spans where u of a line leaves its row of the map */
    MAPPER_LIT,                 /* MAP_PAGE through a light table, the level is that of the
                                   first vertex */
    MAPPER_LIT_GOURAUD,         /* the same, each pixel at its level: GRADIENTS_PLANE,
                                   START_SUBTEXEL */
    MAPPER_DITHERED,            /* as MAPPER_AFFINE, points moved by up to 3/8 texel: see
                                   span_dithered; GRADIENTS_PLANE, START_SUBTEXEL */
    MAPPER_N64,                /* by the material's texture unit: not by polygon_draw */
    MAPPER_GLIDE,               /* by its pipe of Glide's texture units: the same */
    MAPPER_KINDS
};

/* The span routines, for counting their pixels. A polygon with perspective is drawn by one or two
   of PIECES, CURVES, RECIPROCAL and LOGARITHM. */
enum span_kind {
    SPAN_FILL, SPAN_FILL_16, SPAN_FILL_32,      /* the flat ones come first */
    SPAN_GOURAUD, SPAN_AFFINE_ADDX, SPAN_AFFINE_ADDX_WRAP,
    SPAN_AFFINE_ROW, SPAN_AFFINE_COLUMN, SPAN_AFFINE_SCANLINE, SPAN_AFFINE_SWAP,
    SPAN_AFFINE_C, SPAN_ARBITRARY, SPAN_TILED, SPAN_COLUMNS, SPAN_COLUMNS_16,
    SPAN_GENERATED, SPAN_LIT, SPAN_LIT_WRAP, SPAN_LIT_GOURAUD, SPAN_PERSPECTIVE_PIECES,
    SPAN_PERSPECTIVE_CURVES, SPAN_RECIPROCAL, SPAN_LOGARITHM,
    SPAN_AFFINE_COPY, SPAN_AFFINE_SHORT, SPAN_AFFINE_SHORT_WRAP, SPAN_AFFINE_ROW_SHORT,
    SPAN_GOURAUD_SHORT, SPAN_LIT_SHORT, SPAN_LIT_SHORT_WRAP,
    SPAN_AFFINE_16, SPAN_AFFINE_16_WRAP, SPAN_AFFINE_16_ROW, SPAN_AFFINE_16_COPY, SPAN_AFFINE_32,
    SPAN_AFFINE_32_WRAP, SPAN_AFFINE_32_ROW,
    SPAN_DITHERED, SPAN_DITHERED_WRAP, SPAN_DITHERED_16, SPAN_DITHERED_16_WRAP, SPAN_DITHERED_32,
    SPAN_DITHERED_32_WRAP,
    SPAN_N64_PASSES, SPAN_N64_PIXELS, SPAN_GLIDE_PASSES, SPAN_GLIDE_PIXELS,
    SPAN_GLIDE_TILES,
    SPAN_KINDS,
    SPAN_PERSPECTIVE = SPAN_KINDS       /* it is not settled yet which */
};

/* Rules of lowering: reasons to draw with less work than a material's settings require. They are in
   c/drawing/lower.c, line by line. */
enum rule {
    RULE_OUTSIDE,               /* the polygon lies beside the frame: nothing */
    RULE_EQUAL_SHADES,          /* the same pixel at all vertices: flat */
    RULE_EQUAL_LEVELS,          /* the same level of light at all vertices: no interpolation */
    RULE_NO_LIGHT,              /* it makes all texels the same: flat */
    RULE_FULL_LIGHT,            /* it shows the texels as they are: no light */
    RULE_CONSTANT_W,            /* the same depth at all vertices: affine */
    RULE_TOLERANCE,             /* affine is within the material's tolerance */
    RULE_COARSER,               /* pieces, or straight lines, are */
    RULE_INSIDE_FRAME,          /* no line is cut to the frame's columns */
    RULE_INSIDE_RANGE,          /* u and v cannot leave the map, or shades the vertices' range:
                                   no line is moved */
    RULE_STILL_V,               /* v does not change along lines */
    RULE_UNIT_STEP,             /* ... and u moves a texel a pixel: lines are copied */
    RULE_STILL_U,               /* u does not change along lines */
    RULE_NO_WRAP,               /* v wraps once in a line at most */
    RULE_NO_WRAP_LIT,           /* the same in the light */
    RULE_NO_WRAP_DITHERED,      /* v, moved, does not */
    RULE_SHORT,                 /* no line is longer than the cache has room for: no loop; ... */
    RULE_SHORT_WRAP, RULE_SHORT_ROW, RULE_SHORT_GOURAUD, RULE_SHORT_LIT, RULE_SHORT_LIT_WRAP,
    RULE_N64_FLAT,              /* no texel reaches the combiner's result: flat */
    RULE_N64_PLAIN,             /* one tile's points and constants: an affine span of its pixels */
    RULE_N64_PASSES,            /* the modes have passes over lines: not pixel by pixel */
    RULE_GLIDE_PLAIN,           /* one unit's points of one level: an affine span of its pixels */
    RULE_GLIDE_PASSES,          /* as RULE_N64_PASSES */
    RULE_GLIDE_TILES,           /* one LOD, not divided, drawn often enough: from prefiltered tiles */
    RULES
};

struct draw_counts {
    uint32 polygons;            /* that reached a span routine */
    uint32 pixels[SPAN_KINDS];
    uint32 rules[RULES];        /* polygons to which each applied */
};

struct material;
struct drawing;

/* Draws a convex polygon, either winding. */
typedef enum polygon_result polygon_routine(const struct frame *frame,
                                            const struct vertex *vertices, int32 count,
                                            const struct material *material,
                                            const struct drawing *drawing);

/* What a polygon is drawn with. */
struct material {
    uint8 mapper, edges, gradients, start, clip;
    uint8 perspective;          /* MAPPER_AFFINE, GRADIENTS_PLANE, START_SUBTEXEL; 8 bits */
    uint8 whole;                /* MAPPER_AFFINE, GRADIENTS_PLANE: u's lowest bit counts even
                                   where v wraps in a line, for 2 cycles a pixel there */
    uint8 spare[3];
    uint16 number;              /* which of the drawing's counts are its */
    fix16 tolerance;            /* texels that u and v may be off for less perspective, beside
                                   the setting's own bound: 0 to TOLERANCE_MAX */
    uint32 colour;              /* of a flat one: the pixel */
    const struct map *map;      /* in the layout of the mapper */
    const struct map *light;    /* of lit ones: MAP_LIGHT */
    const uint16 *reciprocals;  /* every16, every8: the table's index 0; 0: do without */
    const struct logarithm_tables *logarithms;  /* pixel; 0: do without */
    polygon_routine *draw;      /* what meshes and scenes call for it */
    struct n64_unit *unit;      /* MAPPER_N64 */
    struct glide_pipe *pipe;    /* MAPPER_GLIDE. 48 bytes: an index is multiplied by two additions
                                   and a shift */
};

/* Values of a polygon's vertices that are planes over the screen. */
enum planar_values {
    PLANAR_TEXELS = 1,          /* s and t */
    PLANAR_DEPTHS = 2,          /* 1/w, s/w and t/w */
    PLANAR_SHADES = 4,          /* shade */
    PLANAR_COLOURS = 8,         /* R, G, B and A of shade */
    PLANAR_ALL = 15
};

/* Options for drawing polygons of all materials. */
struct drawing {
    enum form form;
    uint32 off;                 /* bit n: rule n is not followed; exact ones leave the picture
                                   as it is */
    struct draw_counts *counts; /* one a material, or 0; counting takes time */
    uint32 planar;              /* enum planar_values that the caller vouches for: polygons of more
                                   than three vertices are not looked at for them */
};

/* Draws with every mapper except MAPPER_N64 and MAPPER_GLIDE. With GRADIENTS_PLANE, a polygon of
   more than three vertices whose values are not on a plane (fan.c has the tolerance) is drawn as a
   fan of triangles from its first vertex: so every vertex shows its own values. */
polygon_routine polygon_draw;

#endif
