/* Prefiltered tiles: magnified or repeating textures at the price of point sampling.

   Weights of the filter have 4 bits, so what it makes of s and t depends on 1/16 texels alone.
   Where a polygon has one LOD and no changing w, so does the result of the whole chain of units,
   with the finest level that any of them draws: it is a map, 16 times as fine as that level. A
   tile is a part of it, 256x256 pixels of the frame, made row by row with the passes that would
   draw them; lines of polygons are then read from it, the same to the bit. (Weights of 8 bits:
   from level 4 on.)

   All pipes share the tiles that there is memory for; those not drawn from for longest are given
   up. */
#ifndef GLIDE_TILES_H
#define GLIDE_TILES_H

#include "glide/polygons/plan.h"

enum glide_tiles_constants {
    GLIDE_TILES_MAX = 64,
    GLIDE_TILE_BITS = 8,        /* a side has 256 pixels */
    GLIDE_TILE_SET_KEY = 2 + GLIDE_UNITS * (4 + sizeof(struct glide_modes) / 4)
};

/* Rows that polygons may show are paid for at once; each is made where it is first shown. */
struct glide_tile {
    uint8 *memory;
    int32 bytes;
    struct glide_tile_set *set;  /* 0: it shows nothing */
    int32 s, t;                 /* which tile of the map: columns from 256 s on */
    int32 from, end;            /* rows that are made: from to end - 1 */
    int32 low, high;            /* rows that are paid for: low to high */
    uint32 used;                /* when it was last drawn from */
};

/* A chain's result: what tiles are made from. */
struct glide_tile_set {
    uint32 key[GLIDE_TILE_SET_KEY];
    int32 words;                /* of the key; 0: it was never used */
    uint32 direct;              /* pixels that were drawn without tiles, less those paid for */
    uint32 used;
};

enum { GLIDE_TILE_SETS = 8 };

/* The tiles of all pipes that share them. */
struct glide_tile_store {
    struct glide_tile tiles[GLIDE_TILES_MAX];
    struct glide_tile_set sets[GLIDE_TILE_SETS], *last;         /* last: of the polygon before */
    int32 count;                /* tiles with memory */
    uint32 bytes;               /* of all */
    int32 is_full;              /* there was no memory for one more */
    uint32 now;
};

/* How tiles follow each other along an axis. */
enum glide_tiling_kind {
    GLIDE_TILING_ENDLESS,
    GLIDE_TILING_WRAPPED,       /* modulo the period */
    GLIDE_TILING_CLAMPED        /* all before it show the same, and all behind it */
};

struct glide_tiling_axis {
    int32 kind, step;           /* step: 14.18 */
    int32 first, tiles;         /* that the polygon may show */
    int32 low, high;            /* columns or rows of the first and the last of them */
    uint32 origin, size;        /* what is made of the last tile, 14.18; size 0: nothing */
};

/* A polygon that is drawn from tiles. */
struct glide_tiling {
    struct glide_pipe *pipe;
    struct glide_plan *plan;
    struct glide_iterations *iterations;
    struct glide_lod lods[GLIDE_UNITS];  /* of the plan's parts */
    struct glide_tile_set *set;
    struct glide_tiling_axis s, t;
    glide_pass *draw;
    struct glide_paging paging;  /* of the last tile */
    int32 shift;                /* from 14.18 to columns and rows: 14 to 18 */
    int32 period;               /* tiles: 256 of s and t */
    int32 pixel_bytes;
    uint32 now;                 /* no other polygon's */
    struct glide_plan making;
    struct glide_iterations made; /* s and t of a tile's row */
    int32 makes;                /* these two are ready */
};

/* Whether a polygon, its lines found, is drawn from tiles: pixels of the same chain that were drawn
   without them, and its own, are as many as it needs made first, or no tile is missing. What is made then costs no more
   than what had been drawn, or would have been made at once: together at most twice the cheaper
   of both. */
int32 glide_tiles_pay(struct glide_tiling *tiling, struct glide_pipe *pipe, struct glide_plan *plan,
                      struct glide_iterations *iterations, const struct setup *s);

/* tile_lines.c. Draws the polygon's lines; returns how many pixels were drawn one by one. */
uint32 glide_tiles_draw(struct glide_tiling *tiling, const struct setup *s);

/* tile_store.c. How many tiles of these pixels the pipe may have. */
int32 glide_tiles_room(const struct glide_pipe *pipe, int32 pixel_bytes);

/* tile_store.c. The chain's; one that was not used for long is given up for it. */
struct glide_tile_set *glide_tile_set_find(const struct glide_tiling *tiling);

/* tile_store.c. A number for the next polygon. */
uint32 glide_tiles_now(struct glide_tile_store *store);

/* tile_store.c. A tile of the polygon's set; 0: it is not there. */
struct glide_tile *glide_tile_find(const struct glide_tiling *tiling, int32 s, int32 t);

/* tile_store.c. A tile without rows, none paid for; 0: memory is short, and all others are the
   polygon's. */
struct glide_tile *glide_tile_take(const struct glide_tiling *tiling, int32 s, int32 t);

static inline int32 glide_tile_held(int32 tile, int32 period)
{
    return tile < -1 ? -1 : tile > period ? period : tile;
}

/* Which of the tiles that differ shows what the tile-th along an axis would. */
static inline int32 glide_tile_number(const struct glide_tiling *tiling,
                                      const struct glide_tiling_axis *axis, int32 tile)
{
    return axis->kind == GLIDE_TILING_WRAPPED ? tile & (tiling->period - 1)
        : axis->kind == GLIDE_TILING_CLAMPED ? glide_tile_held(tile, tiling->period) : tile;
}

/* Where row v of 256 lies. */
static inline uint8 *glide_tile_row(const struct glide_tile *tile, int32 v, int32 pixel_bytes)
{
    return tile->memory + ((v ^ MAP_PAGE_SIDE / 2) * MAP_PAGE_SIDE * pixel_bytes);
}

#endif
