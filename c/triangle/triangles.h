/* Batches of triangles with snapped vertices, set up in 32 bits. */
#ifndef TRIANGLES_H
#define TRIANGLES_H

#include "polygon/polygon.h"
#include "span/scanline.h"

enum snapped_limits {
    /* Vertices are snapped to 1/SNAPPED_ONE pixel. */
    SNAPPED_BITS = 4,
    SNAPPED_ONE = 1 << SNAPPED_BITS,
    SNAPPED_HALF = 1 << (15 - SNAPPED_BITS),        /* of that, 16.16 */
    SNAPPED_MASK = (1 << (16 - SNAPPED_BITS)) - 1,  /* what rounding clears */

    /* A triangle is drawn where x is 0 to SNAPPED_WIDTH, it covers less than SNAPPED_LINES lines, and
       u and v of its vertices are -SNAPPED_TEXELS to SNAPPED_TEXELS (excluded). */
    SNAPPED_WIDTH = 320,
    SNAPPED_LINES = 256,
    SNAPPED_TEXELS = 512,
    TRIANGLE_PITCH_MAX = 2048,

    /* Added to u and v of vertices, 1/65536 texel: as much as a pixel's may be too low in a triangle of
       fewer than SNAPPED_TALL lines. TALL_RAISED is added to others. */
    SNAPPED_RAISED = 512,
    SNAPPED_TALL = 128,
    TALL_RAISED = 160,

    /* The greatest height of small triangles, 1/16 line: their edges have 16 bits of fraction. */
    SMALL_HEIGHT = 224,

    /* Reciprocals: 2^31 / dy, from FINER_HEIGHT sixteenths of a line on 2^39 / dy. */
    FINER_HEIGHT = 256,
    SNAPPED_RECIPROCALS = SNAPPED_LINES * SNAPPED_ONE,

    SHADES_STEEP = 256,         /* a step of so many shades a pixel is drawn as 0: no line of such a
                                   triangle has two pixels */
    LEVELS_STEEP = 64,          /* the same for levels of light */

    /* MAPPER_ARBITRARY: u and v of vertices are so far inside the map, 1/65536 texel, that no pixel of
       a triangle with an area of SLIVER_MAP dy or more leaves it: its gradients are below 86 texels
       a pixel, its values up to 483 units below the exact ones and 1,835 above. */
    BELOW_MAP = 512,
    ABOVE_MAP = 2048,
    SLIVER_MAP = 48,            /* twice the area in 1/256 square pixel, dy in 1/16 line */

    /* Up to these areas, in 1/512 square pixel, the quotient of a gradient may not fit 32 bits. Its
       dividend is below 2 * 2^30 dy, u and v being less than 1,024 texels apart. */
    SLIVER_SMALL = 256,         /* dy up to 224 */
    SLIVER_WIDE = SNAPPED_RECIPROCALS
};

/* A vertex of a batch. */
struct snapped_vertex {
    int16 x, y;                 /* 12.4: x + 1 and y + 15/16; x below 0: out of range */
    int32 u, v;                 /* 12.20 texels, modulo 4,096; Gouraud: u is the shade */
    int32 level;                /* lit: of the light table, 12.20; 16 bytes: an index is a shift */
};

struct triangle {
    const struct snapped_vertex *a, *b, *c;
};

/* What vertices of triangles are interpolated with. */
enum vertex_values {
    VALUES_NONE, VALUES_SHADES, VALUES_TEXELS,
    VALUES_LEVEL,               /* texels, and the first vertex's level of light */
    VALUES_LEVELS
};

struct vertices_plan {
    int32 count;
    uint32 right, bottom;       /* largest x and y, 1/16 pixel */
    const struct vertex *from;
    struct snapped_vertex *to;
    fix16 scale;                /* of the map; 0 for 1 */
    int32 values;               /* enum vertex_values */
};

struct fans_plan {
    uint32 right, bottom;       /* as above */
    struct snapped_vertex *vertices;    /* room for those of all polygons */
    const struct polygon *from;
    fix16 scale;
    struct triangle *list;      /* the same */
    const struct polygon *end;
    int32 values;
    int32 judged;               /* 1: no polygon is taken before it is judged */
    int32 skips;                /* 1: polygons beyond a side of the frame are left out; scale up to 1 */
    fix16 beyond_x, beyond_y;   /* where they are at the right and below */
    struct snapped_vertex *free;        /* set behind the vertices of the last polygon that was taken */
    struct triangle *last;      /* set behind the last triangle */
    int32 is_odd;               /* set to 1 if the vertices of the next one are there, to be judged */
};

/* Room for what triangles_spans makes. */
struct triangle_lines {
    struct span_plan span;
    struct shade_plan shade;
};

/* Everything a routine for triangles needs. */
struct triangle_plan {
    const struct triangle *list, *end;
    uint8 *row;                 /* row 0 of the frame */
    int32 pitch;                /* bytes from line to line, up to TRIANGLE_PITCH_MAX */
    const uint8 *map;           /* texel (0, 0) */
    const int32 *reciprocals;   /* SNAPPED_RECIPROCALS */
    uint32 colour;              /* flat: four pixels */
    int32 cull;                 /* 1: triangles seen from the back are left out */

    /* triangles_spans, whose row is the pixel -EDGE_BIAS: */
    const struct triangle *(*lines)(struct triangle_plan *plan);        /* triangle_lines_<form> */
    int32 kind;                 /* enum span_kind of the lines */
    int32 lowered;              /* set to what the last triangle's were lowered to */
    int32 only_counts;          /* 1: nothing is drawn */
    uint32 off;                 /* the renderer's: rules that are off */
    const uint8 *light;         /* the light table, or 0 */
    uint32 *shades;             /* room for one a line, or 0: one level a triangle */
    struct span_plan *span;     /* its lines, pitch, map and colour are set */
    struct shade_plan *shade;   /* lit Gouraud */
};

/* What polygon_draw needs to draw triangles with snapped vertices. */
struct triangle_tables {
    enum span_kind (*draw)(const struct renderer *renderer, const struct polygon *polygon,
                           const struct material *material);    /* triangle_polygon */
    enum polygon_result (*run)(struct renderer *renderer, const struct polygon *polygons,
                               int32 count, const struct material *material,
                               polygon_routine *other);         /* triangle_run */
    int32 reciprocals[SNAPPED_RECIPROCALS];
};

void triangle_tables_make(struct triangle_tables *tables);

/* Their reciprocals alone, for plans that are ready. */
void triangle_reciprocals_make(int32 *table);

/* src68k/triangle has contracts of these and the following. */
void triangle_vertices(const struct vertices_plan *plan);
const struct polygon *triangle_fans(struct fans_plan *plan);

/* They draw the list up to the first triangle that they cannot draw, and return its address, or the
   list's end. triangles_spans, in C, makes a scanline table for each triangle and calls a span. */
const struct triangle *triangles_flat(struct triangle_plan *plan);
const struct triangle *triangles_gouraud(struct triangle_plan *plan);
const struct triangle *triangles_affine(struct triangle_plan *plan);
const struct triangle *triangles_spans(struct triangle_plan *plan);

/* The scanline table of the list's first triangle that has lines. They return the address behind it;
   with no line, as above. */
const struct triangle *triangle_lines_flat(struct triangle_plan *plan);
const struct triangle *triangle_lines_addx(struct triangle_plan *plan);
const struct triangle *triangle_lines_levels(struct triangle_plan *plan);

#endif
