/* Texture maps in memory. */
#ifndef MAP_H
#define MAP_H

#include "compiler.h"

/* The index of texel (u, v). */
enum map_layout {
    MAP_PAGE,                   /* 256 v + u, modulo 256 each: a 256x256 page at a multiple
                                   of 65,536; a smaller map is repeated in it. Texels of 2
                                   or 4 bytes: at a multiple of them, rows 128 to 255 before
                                   rows 0 to 127, as if that sum were an int16 */
    MAP_LINEAR,                 /* width v + u; any address */
    MAP_TILED,                  /* 256x256 in tiles of 8x8: 2048 (u/8) + 8 v + u%8; at a
                                   multiple of 65,536 */
    MAP_COLUMNS,                /* columns 4 texels wide: 4 height (u/4) + 4 v + u%4 */
    MAP_MARGINS,                /* MAP_PAGE, with a copy of its second half before it and of
                                   its first half after it */
    MAP_LIGHT,                  /* 256 level + texel: the pixel of a texel at a level of light;
                                   at a multiple of 256, inside a page */
    MAP_LAYOUTS
};

enum map_constants {
    MAP_SIDE_MIN = 8,           /* of repeating maps, whose sides are powers of two */
    MAP_PAGE_SIDE = 256,
    MIPMAP_LEVELS_MAX = 5,      /* beyond the map: from 256 texels to MAP_SIDE_MIN */
    LIGHT_LEVELS = 64,          /* MAP_LIGHT: from dark to full light */
    MAP_LINEAR_MAX = 1024,      /* MAP_LINEAR: 1 to this, each side */
    MAP_COLUMNS_BITS = 18       /* MAP_COLUMNS: log2(width) + log2(height) at most */
};

/* Of a row of a map, for texels that are transparent if they are 0. */
struct map_row {
    uint8 first, last;          /* opaque texels; first > last: there are none */
    uint8 holes;                /* 1: not all between them are opaque; or 0 */
    uint8 unused;
};

struct map {
    const uint8 *texels;        /* (u, v) = (0, 0) */
    int32 width, height;        /* texels */
    fix16 scale;                /* texels per unit of s or t: the longer side / 256 */
    uint8 layout;
    uint8 texel_bytes;          /* 1, 2 or 4: as many as the frame's pixels have */
    uint8 full, dark;           /* MAP_LIGHT, 1: the last level leaves texels unchanged; the
                                   first level makes all texels the same */
    const struct map_row *rows; /* MAP_PAGE: `height` of them; or 0 */
};

/* Returns the scale of a map of this size. */
fix16 map_scale(int32 width, int32 height);

/* Fills in the rows of a map of one-byte texels. */
void map_rows_make(struct map_row *rows, const struct map *map);

/* Column layout, from a map's size: the parts of a texel's index.
     tttttvvvvvvvuu      t: column, v: row (v_bits of it), u: texel in the column     */
struct column_layout {
    uint32 v_bits;              /* 3 to 15 */
    uint32 u_mask, v_mask;      /* t and u; v */
};

/* Fills in a column layout. Returns 0 if there is none for the map's size: sides must be powers of
   two from 8 to 2^15, with MAP_COLUMNS_BITS bits together at most. */
int32 column_layout_make(struct column_layout *layout, int32 width, int32 height);

#endif
