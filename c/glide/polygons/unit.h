/* Texture units that draw polygons, and data cached from their state. */
#ifndef GLIDE_UNIT_H
#define GLIDE_UNIT_H

#include "drawing/page.h"
#include "glide/polygons/bands.h"
#include "glide/polygons/decode.h"
#include "glide/polygons/lines.h"

enum glide_limits {
    GLIDE_REACH = 8192,         /* s and t: below, and above -GLIDE_REACH */
    GLIDE_DITHERED_MARGIN = 2,  /* points move, and leave the vertices' range, by less */
    GLIDE_TILES_BYTES = 1 << 20  /* of prefiltered tiles, unless a pipe says otherwise */
};

struct glide_tile_store;

/* The first unit's LOD and level, if all its pixels have the same. */
struct glide_only {
    uint32 modes;               /* mode_generation + 1; 0: not found yet */
    int32 is_one;
    struct glide_lod lod;
    struct glide_level level;
};

struct glide_pipe {
    struct glide_chain chain;
    enum glide_result result;   /* why the last polygon was refused */
    int32 memory;               /* enum memory_type, of cached data */
    uint32 prefilter;           /* see glide_pipe_prefilter */
    int32 adds;                 /* see glide_pipe_adds */
    struct glide_tile_store *tiles;
    struct glide_only only;
    struct page page;           /* a level as the plain mappers read it */
    uint32 paged;               /* the first unit's state when a polygon was last drawn from it */
    struct glide_kept levels[GLIDE_UNITS][GLIDE_LEVEL_LAST + 1];  /* decoded for the passes */
    struct glide_bands bands[GLIDE_UNITS];
    struct glide_lines lines;
};

/* No tile is made yet. */
void glide_tile_store_init(struct glide_tile_store *store);

/* A pipe of units that are there already, none of them with points of its own. tiles: those of all
   pipes that are to share memory. */
enum glide_result glide_pipe_init(struct glide_pipe *pipe, struct glide *const *units, uint32 count,
                                  int32 memory, struct glide_tile_store *tiles);

/* Sets how many bytes the prefiltered tiles (tiles.h) of all pipes together may take; with 0 the
   pipe uses none. A tile of a 16-bit frame has 128 KB, of a 32-bit one 256. The picture is the
   same. */
void glide_pipe_prefilter(struct glide_pipe *pipe, uint32 bytes);

/* Sets Glide's blend ONE, ONE. 1: polygons are added to the frame; 0, as in a new pipe: they
   replace its pixels; any other number: returns GLIDE_BAD_FLAG and changes nothing. Each of R, G, B
   and A becomes the sum of the frame's and the polygon's, 255 at most. A 5/6/5 pixel counts as 8
   bits a channel (r << 3 | r >> 2, g << 2 | g >> 4, b as r), and the sum's upper 5, 6, 5 bits are
   stored. */
enum glide_result glide_pipe_adds(struct glide_pipe *pipe, uint32 adds);

/* Draws a convex polygon with the units of a material's pipe into a frame of 2 (5/6/5) or 4 bytes
   (R G B A) a pixel. The material's edges (subpixel or exact) and clip are used too. s and t of
   vertices are 0 to 256 along the longer side of a map, whatever its size, and less than
   GLIDE_REACH apart. If a unit divides, w must not be 0 and is W_MAX at most. Like polygon_draw it
   splits a polygon of more than three vertices into triangles if their values, or their separate
   points', are not on a plane. If it returns POLYGON_REFUSED, pipe->result has the reason. */
polygon_routine glide_polygon_draw;

/* lower.c. Returns non-zero if the plain mappers can draw the polygon from a page that shows the
   level. Makes the page and its material, and sets *vertices to the vertices relative to the page.

   MAPPER_DITHERED is used, whichever rules are off, if all of this is true: the unit's mode
   `dithered` is 1, it filters one level bilinearly, there is no other unit, no division (w is above
   0 and the same at all vertices if there would be one), and the vertices are at least
   GLIDE_DITHERED_MARGIN texels from where texels would be clamped, and there is memory for the page;
   without it the polygon is filtered. s and t are then in texels of that level, rounded down. */
int32 glide_lower_to_plain(struct setup *s, struct glide_pipe *pipe, const struct vertex **vertices);

/* A number that grows with each change of a unit's state. */
static inline uint32 glide_state(const struct glide *unit)
{
    return unit->mode_generation + unit->memory_generation + unit->table_generation;
}

/* lower.c. Draws a triangle from the page, whose state is that of the polygon before; its coordinates are near
   enough. Returns enum polygon_result, or -1: it must be lowered. */
int32 glide_page_again(struct glide_pipe *pipe, struct renderer *renderer, const struct vertex *given);

/* Returns 0 if glide_lower_to_plain can do nothing: the first unit always filters, and divides nothing. */
static inline int32 glide_may_be_plain(const struct glide_pipe *pipe)
{
    const struct glide_modes *modes = &pipe->chain.units[0]->modes;

    return modes->minify == GLIDE_POINT || modes->magnify == GLIDE_POINT || modes->perspective || modes->dithered;
}

/* Returns non-zero if the second unit has separate points. */
static inline int32 glide_has_own(const struct glide_chain *chain)
{
    return chain->count > 1 && chain->own & 2;
}

/* Returns the frame's pixel, in the lower bits, of A R G B. */
static inline uint32 glide_frame_pixel(uint32 argb, int32 pixel_bytes)
{
    if (pixel_bytes == 4)
        return argb << 8 | argb >> 24;
    return (argb >> 8 & 0xf800) | (argb >> 5 & 0x7e0) | (argb >> 3 & 0x1f);
}

/* Returns the colour of a 5/6/5 pixel: R G B and 0. */
static inline uint32 glide_wide_565(uint32 pixel)
{
    const uint32 r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;

    return (r << 3 | r >> 2) << 24 | (g << 2 | g >> 4) << 16 | (b << 3 | b >> 2) << 8;
}

#endif
