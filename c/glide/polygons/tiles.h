/* Prefiltered tiles: magnified or repeating textures at the price of point sampling.

   The filter's weights have 4 bits, so its result depends only on s and t in 1/16 texels. If a
   polygon has one LOD and a constant w, the same is true of the whole chain of units, in texels of
   the finest level that any of them draws. Its result is a map, 16 times as fine as that level. A
   tile is a part of this map, 256x256 pixels of the frame, made row by row with the passes that
   would draw them. Lines of polygons are then read from it and are the same to the bit. (Weights of
   8 bits: from level 4 on.)

   All pipes share the tiles that there is memory for. The least recently used ones are reused. */
#ifndef GLIDE_TILES_H
#define GLIDE_TILES_H

#include "glide/polygons/plan.h"

enum glide_tiles_constants {
    GLIDE_TILES_MAX = 64,
    GLIDE_TILES_LEAST = 320,    /* pixels of a polygon's box that asks for tiles */
    GLIDE_TILE_BITS = 8,        /* a side has 256 pixels */
    GLIDE_TILE_SET_KEY = 2 + GLIDE_UNITS * (4 + sizeof(struct glide_modes) / 4)
};

/* All rows that a polygon may show are paid for together; each is made when it is first shown. */
struct glide_tile {
    uint8 *memory;
    int32 bytes;
    struct glide_tile_set *set;  /* null: the tile is empty */
    int32 s, t;                 /* the tile's place in the map: columns from 256 s on */
    int32 from, end;            /* rows that are made: from to end - 1 */
    int32 low, high;            /* rows that are paid for: low to high */
    uint32 used;                /* when it was last drawn from */
};

/* A chain's result, of which tiles are made. */
struct glide_tile_set {
    uint32 key[GLIDE_TILE_SET_KEY];
    int32 words;                /* of the key; 0: not used yet */
    uint32 direct;              /* pixels drawn without tiles, less those paid for */
    uint32 used;
};

enum { GLIDE_TILE_SETS = 8 };

/* What all pipes of a scene share: tiles and tables. */
struct glide_tile_store {
    struct glide_logarithm *logarithms;  /* null until a unit needs LODs */
    uint8 *products;            /* null until a unit multiplies what it filters */
    struct glide_tile tiles[GLIDE_TILES_MAX];
    struct glide_tile_set sets[GLIDE_TILE_SETS], *last;         /* last: of the polygon before */
    int32 count;                /* tiles with memory */
    uint32 bytes;               /* of all */
    int32 is_full;              /* there was no memory for one more */
    uint32 now;                 /* number of the last polygon */
};

/* How tiles follow each other along an axis. */
enum glide_tiling_kind {
    GLIDE_TILING_ENDLESS,
    GLIDE_TILING_WRAPPED,       /* modulo the period */
    GLIDE_TILING_CLAMPED        /* all before it are equal, and all behind it */
};

struct glide_tiling_axis {
    int32 kind, step;           /* step: 14.18 */
    int32 first, tiles;         /* tiles that the polygon may show */
    int32 low, high;            /* first column or row of the first, last one of the last */
    uint32 origin, size;        /* made part of the tile last used, 14.18; size 0: none */
};

/* A polygon that is drawn from tiles. */
struct glide_tiling {
    struct glide_pipe *pipe;
    struct glide_plan *plan;
    struct glide_iterations *iterations;
    struct glide_lod lods[GLIDE_UNITS];  /* the plan's parts' */
    struct glide_tile_set *set;
    struct glide_tiling_axis s, t;
    glide_pass *draw;
    struct glide_paging paging;  /* of the tile last used */
    int32 shift;                /* from 14.18 to columns and rows: 14 to 18 */
    int32 period;               /* tiles: 256 of s and t */
    int32 pixel_bytes;
    uint32 now;                 /* the polygon's number */
    struct glide_plan making;
    struct glide_iterations made; /* s and t of a tile's row */
    int32 makes;                /* making and made are ready */
};

/* Whether tiles are asked for: what they spare grows with a polygon's pixels, asking costs the same. */
static inline int32 glide_tiles_may_pay(const struct glide_pipe *pipe,
                                        const struct glide_iterations *at, const struct setup *s)
{
    return pipe->prefilter && !at->divided[0]
        && (s->box.right - s->box.left) * (s->box.bottom - s->box.top) >= GLIDE_TILES_LEAST;
}

/* Whether a polygon, its lines found, is drawn from tiles: pixels of the same chain that were drawn
   without them, and its own, are as many as it needs made first, or no tile is missing. What is made then costs no more
   than what had been drawn, or would have been made at once: together at most twice the cheaper
   of both. */
int32 glide_tiles_pay(struct glide_tiling *tiling, struct glide_pipe *pipe, struct glide_plan *plan,
                      struct glide_iterations *iterations, const struct setup *s);

/* tile_lines.c. Draws the polygon's lines; returns how many pixels were drawn one by one. */
uint32 glide_tiles_draw(struct glide_tiling *tiling, const struct setup *s);

/* tile_store.c. Returns how many tiles of these pixels the pipe may have. */
int32 glide_tiles_room(const struct glide_pipe *pipe, int32 pixel_bytes);

/* tile_store.c. Returns the chain's set; a new one replaces the least recently used. */
struct glide_tile_set *glide_tile_set_find(const struct glide_tiling *tiling);

/* tile_store.c. A tile of the polygon's set; 0: it is not there. */
struct glide_tile *glide_tile_find(const struct glide_tiling *tiling, int32 s, int32 t);

/* tile_store.c. Returns a tile without rows, none paid for, or null: there is no memory, and the
   polygon uses all the others. */
struct glide_tile *glide_tile_take(const struct glide_tiling *tiling, int32 s, int32 t);

static inline int32 glide_tile_held(int32 tile, int32 period)
{
    return tile < -1 ? -1 : tile > period ? period : tile;
}

/* Returns the number of the tile that shows the same as the tile-th along an axis. */
static inline int32 glide_tile_number(const struct glide_tiling *tiling,
                                      const struct glide_tiling_axis *axis, int32 tile)
{
    return axis->kind == GLIDE_TILING_WRAPPED ? tile & (tiling->period - 1)
        : axis->kind == GLIDE_TILING_CLAMPED ? glide_tile_held(tile, tiling->period) : tile;
}

/* Returns the address of row v of 256. */
static inline uint8 *glide_tile_row(const struct glide_tile *tile, int32 v, int32 pixel_bytes)
{
    return tile->memory + ((v ^ MAP_PAGE_SIDE / 2) * MAP_PAGE_SIDE * pixel_bytes);
}

#endif
