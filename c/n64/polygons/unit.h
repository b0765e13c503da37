/* A texture engine that draws polygons, with what was made ready of its state. */
#ifndef N64_UNIT_H
#define N64_UNIT_H

#include "drawing/page.h"
#include "n64/pixel.h"
#include "n64/polygons/decode.h"

enum { N64_PAGE_KEY = 10 };

/* A tile as the plain mappers read it: see page.h. */
struct n64_page {
    struct page page;
    uint32 key[N64_PAGE_KEY];   /* what it was made from */
};

/* What YUV texels become: see n64_yuv_conversion. */
struct n64_yuv_tables {
    struct n64_matrix matrix;
    uint32 colours[512];
};

struct n64_unit {
    struct n64 n64;
    enum n64_result result;     /* why the last polygon was refused */
    int32 memory;               /* enum memory_kind, of what is made ready */
    struct n64_levels *levels;  /* of levels_made, a mode_generation; or 0 */
    uint32 levels_made;
    uint8 *tables;              /* of tables_made, another; or 0 */
    uint32 tables_made;
    uint32 judged;              /* generations of tiles and modes that can be drawn with */
    struct n64_yuv_tables *yuv;  /* of yuv_made, another; or 0 */
    uint32 yuv_made;
    struct n64_page page;
    struct n64_colours colours;
    struct n64_kept tiles[N64_TILES];   /* decoded for the passes */
    struct n64_kept chroma[N64_TILES];  /* the same with quads for YUV's chroma */
};

/* A unit with its engine as n64_init leaves it. */
void n64_unit_init(struct n64_unit *unit, const uint8 *dram, uint32 dram_bytes, int32 memory);

/* POLYGON_REFUSED, for a reason that the unit keeps. */
enum polygon_result n64_refused(struct n64_unit *unit, enum n64_result result);

/* Draws a convex polygon by the unit of a material, into a frame of 2 (5/5/5/1) or 4 bytes
   (R G B A) a pixel. Of the material edges (subpixel or exact) and clip count besides; of the
   vertices s and t are texels before a tile's shift, -1,024 to 1,024, less than 1,024 apart.
   As polygon_draw it makes triangles of more than three vertices on no plane.
   POLYGON_REFUSED: unit->result says why. */
polygon_routine n64_polygon_draw;

/* The same, with colours for the combiner's shade: the shade of each vertex is its R G B A.
   Above it is a grey, 16.16, whose alpha is 255. */
polygon_routine n64_polygon_draw_coloured;

/* A rectangle's corners in copy mode, where the plain mappers draw it: a texel a pixel. Otherwise
   it is refused with N64_CYCLE_TYPE, as polygons are. */
polygon_routine n64_polygon_copy;

#endif
