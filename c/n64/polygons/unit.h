/* A texture engine that draws polygons, and data cached from its state. */
#ifndef N64_UNIT_H
#define N64_UNIT_H

#include "drawing/page.h"
#include "n64/pixel.h"
#include "n64/polygons/decode.h"

/* Tables for converting YUV texels: see n64_yuv_conversion. */
struct n64_yuv_tables {
    struct n64_matrix matrix;
    uint32 colours[512];
};

struct n64_plan;

struct n64_unit {
    struct n64 n64;
    enum n64_result result;     /* why the last polygon was refused */
    int32 memory;               /* enum memory_type, of cached data */
    uint32 **reciprocals;       /* of all units of a scene; *reciprocals is null until needed */
    struct n64_levels *levels;  /* made for the modes levels_of; or null */
    struct n64_level_modes levels_of;
    uint32 *tables;             /* n64_map's, made at mode_generation tables_made; or null */
    uint32 tables_made;
    uint32 validated;           /* sum of generations of the last state found valid */
    uint32 used;                /* its n64_tiles_used */
    struct n64_yuv_tables *yuv;  /* made at mode_generation yuv_made; or null */
    uint32 yuv_made;
    struct n64_plan *plan;      /* of the last polygon drawn by passes; or null */
    struct page page;           /* a tile as the plain mappers read it: page.h */
    struct page_window columns, rows;   /* of it */
    uint32 paged;               /* sum of generations when a polygon without shades was last drawn from it */
    struct n64_colours colours;
    struct n64_kept tiles[N64_TILES];   /* decoded for the passes */
    struct n64_kept chroma[N64_TILES];  /* the same with quads for YUV's chroma */
};

/* Initialises a unit and its engine (n64_init). reciprocals: units that share one table share the
   pointer to it, null at first. */
void n64_unit_init(struct n64_unit *unit, const uint8 *dram, uint32 dram_bytes, int32 memory,
                   uint32 **reciprocals);

/* Returns the sum of the generations of all that a picture depends on. */
uint32 n64_unit_state(const struct n64_unit *unit);

/* Sets unit->result and returns POLYGON_REFUSED. */
enum polygon_result n64_refused(struct n64_unit *unit, enum n64_result result);

/* Draws a convex polygon with a material's unit into a frame of 2 (5/5/5/1) or 4 bytes (R G B A) a
   pixel. The material's edges (subpixel or exact) and clip are used too. s and t of vertices are
   texels before a tile's shift, -1,024 to 1,024, less than 1,024 apart. Like polygon_draw it splits
   a polygon of more than three vertices into triangles if their values are not on a plane. If it
   returns POLYGON_REFUSED, unit->result has the reason. */
polygon_routine n64_polygon_draw;

/* Draws the same with colours for the combiner's shade: the shade of each vertex is its R G B A. In
   n64_polygon_draw it is a grey, 16.16, whose alpha is 255. */
polygon_routine n64_polygon_draw_coloured;

/* Draws a rectangle's corners in copy mode if the plain mappers can: a texel a pixel. Otherwise it
   is refused with N64_CYCLE_TYPE, as polygons are. */
polygon_routine n64_polygon_copy;

#endif
