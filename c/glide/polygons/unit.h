/* Texture units that draw polygons, with what was made ready of their state. */
#ifndef GLIDE_UNIT_H
#define GLIDE_UNIT_H

#include "drawing/page.h"
#include "glide/polygons/bands.h"
#include "glide/polygons/decode.h"

enum { GLIDE_PAGE_KEY = 4 };

enum glide_limits {
    GLIDE_REACH = 8192,         /* s and t: below, and above -GLIDE_REACH */
    GLIDE_DITHERED_MARGIN = 2,  /* more than points are moved and leave the vertices' range */
    GLIDE_TILES_BYTES = 1 << 20  /* of prefiltered tiles, unless a pipe says otherwise */
};

/* A level as the plain mappers read it: pixels of the frame. */
struct glide_page {
    struct page page;
    uint32 key[GLIDE_PAGE_KEY];  /* what it was made from */
};

struct glide_tile_store;

struct glide_pipe {
    struct glide_chain chain;
    enum glide_result result;   /* why the last polygon was refused */
    int32 memory;               /* enum memory_kind, of what is made ready */
    uint32 prefilter;           /* see glide_pipe_prefilter */
    int32 adds;                 /* see glide_pipe_adds */
    struct glide_tile_store *tiles;
    struct glide_page page;
    struct glide_kept levels[GLIDE_UNITS][GLIDE_LEVEL_LAST + 1];  /* decoded for the passes */
    struct glide_bands bands[GLIDE_UNITS];
};

/* No tile is made yet. */
void glide_tile_store_init(struct glide_tile_store *store);

/* A pipe of units that are there already, none of them with points of its own. tiles: those of all
   pipes that are to share memory. */
enum glide_result glide_pipe_init(struct glide_pipe *pipe, struct glide *const *units, uint32 count,
                                  int32 memory, struct glide_tile_store *tiles);

/* How many bytes prefiltered tiles (tiles.h) may take, those of all pipes together; 0: the pipe
   does without. A tile of a 16-bit frame has 128 KB, of a 32-bit one 256. The picture is the
   same. */
void glide_pipe_prefilter(struct glide_pipe *pipe, uint32 bytes);

/* Glide's blend ONE, ONE: 1: polygons are added to the frame; 0, as in a new pipe: they replace its
   pixels. GLIDE_BAD_FLAG: any other number, which changes nothing. Each of R, G, B and A becomes the
   frame's and the polygon's, 255 at most. A 5/6/5 pixel counts as a texel of 8 bits a channel
   (r << 3 | r >> 2, g << 2 | g >> 4, b as r); of the sum the upper 5, 6, 5 bits are stored. */
enum glide_result glide_pipe_adds(struct glide_pipe *pipe, uint32 adds);

/* Draws a convex polygon by the units of a material's pipe, into a frame of 2 (5/6/5) or 4 bytes
   (R G B A) a pixel. Of the material edges (subpixel or exact) and clip count besides; of the
   vertices s and t, 0 to 256 along the longer side of a map whatever its size, those of two
   vertices less than GLIDE_REACH apart, and where a unit divides w, not 0, W_MAX at most.
   As polygon_draw it makes triangles of more than three vertices on no plane, by the own points
   too.
   POLYGON_REFUSED: pipe->result says why. */
polygon_routine glide_polygon_draw;

/* lower.c. Whether the plain mappers draw it: by a page that shows the level, with the material
   for them in *plain and the vertices relative to the page. So they do, whatever rules are off, for
   a unit whose mode `dithered` is 1, the bilinear filter of one level alone, no other unit, no
   divide (w the same at all vertices and above 0 where there would be one), and vertices
   GLIDE_DITHERED_MARGIN texels or more from where texels would be clamped: by MAPPER_DITHERED, s and
   t in texels of that level, rounded down. */
int32 glide_lower_to_plain(struct setup *s, struct glide_pipe *pipe, struct material *plain,
                           const struct vertex **vertices);

/* Whether the second unit has points of its own. */
static inline int32 glide_has_own(const struct glide_chain *chain)
{
    return chain->count > 1 && chain->own & 2;
}

/* A frame's pixel, in its lower bits, of A R G B. */
static inline uint32 glide_frame_pixel(uint32 argb, int32 pixel_bytes)
{
    if (pixel_bytes == 4)
        return argb << 8 | argb >> 24;
    return (argb >> 8 & 0xf800) | (argb >> 5 & 0x7e0) | (argb >> 3 & 0x1f);
}

/* The colour of a 5/6/5 pixel, R G B and 0. */
static inline uint32 glide_wide_565(uint32 pixel)
{
    const uint32 r = pixel >> 11, g = pixel >> 5 & 63, b = pixel & 31;

    return (r << 3 | r >> 2) << 24 | (g << 2 | g >> 4) << 16 | (b << 3 | b >> 2) << 8;
}

#endif
