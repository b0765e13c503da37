/* Tiles decoded ahead: the passes over a line's pixels read them instead of TMEM. */
#ifndef N64_DECODE_H
#define N64_DECODE_H

#include "n64/passes.h"
#include "n64/polygons/scratch.h"

enum n64_decode_constants {
    N64_DECODE_BITS = 15        /* columns_bits + rows_bits, at most: all that fits into TMEM,
                                   mirrored; 128 KB of texels, 2 MB of quads */
};

/* The neighbours in a decoded tile's quads: no quads; the next texels; or in s the ones after the
   next, for YUV's chroma, which two texels share, and whose texels have U + 128 for A too. */
enum n64_quads { N64_QUADS_NONE, N64_QUADS_NEXT, N64_QUADS_CHROMA };

enum { N64_TILE_KEY = 3, N64_KEPT_KEY = N64_TILE_KEY + 3 };

/* Writes the N64_TILE_KEY longs of the cache key of a tile's texels, apart from TMEM and TLUT
   modes. An axis' edges are part of it only if it clamps: relative coordinates allow for the
   origin. */
void n64_tile_key_find(uint32 *key, const struct n64_tile *tile);

/* A cached decoded tile and its cache key. All 0 before the first use. */
struct n64_kept {
    struct n64_decoded decoded;
    uint32 key[N64_KEPT_KEY];   /* of the modes, only TLUT's matter; the last long: the engine */
    enum n64_quads kind;
    uint32 *texels;
    struct n64_quad *quads;
    uint32 texels_room, quads_room;     /* elements */
};

/* Of formats whose texels are numbers: the colour of each, and what it was made from, so that only
   entries of a TLUT that changed are made again. All 0 before the first use. */
struct n64_colours {
    uint32 of[256], from[256];
};

/* rows.c. How a tile's rows are decoded: see n64_rows_find. */
struct n64_rows {
    struct n64_decode_scratch *scratch;
    const struct n64_colours *colours;
    const struct n64 *n64;
    const struct n64_tile *tile;
    void (*decode)(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                   int32 count);        /* null: texel by texel */
};

/* Valid until TMEM, the modes or the tile change, or colours are found for another. */
void n64_rows_find(struct n64_rows *rows, const struct n64 *n64, const struct n64_tile *tile,
                   struct n64_decode_scratch *scratch, struct n64_colours *colours);

/* Decodes texels 0 to count - 1 (1,024 at most) of a row (0 to 256), and perhaps one more: R G B A
   as n64_fetch gives them, from the first copies of TLUT entries. YUV is U + 128, V + 128, Y, Y. */
void n64_rows_decode(const struct n64_rows *rows, int32 row, uint32 *texels, int32 count);

/* Returns any one texel; s and row as n64_fetch has them. */
uint32 n64_rows_texel(const struct n64_rows *rows, int32 s, int32 row);

/* What tiles are decoded with. */
struct n64_decoding {
    struct n64_decode_scratch *scratch;
    struct n64_colours *colours;
    int32 made;                 /* by n64_decode: 1 the tile was decoded, 0 it was already */
};

/* Makes *kept fit tile n, with quads or without, unless it does already. Memory is the system's and
   kept for the next time; a larger tile takes new memory, and what it had stays taken until the
   program ends. Colours are n64_fetch's; of a TLUT entry's four copies only the first counts (loads
   make them equal). YUV texels have U + 128 and V + 128 for R and G, Y for B and A; filters leave
   that as it is. */
enum n64_result n64_decode(struct n64_decoding *decoding, const struct n64 *n64, int32 n,
                           enum n64_quads quads, struct n64_kept *kept);

#endif
