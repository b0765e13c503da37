/* Tiles decoded ahead: the passes over a line's pixels read them instead of TMEM. */
#ifndef N64_DECODE_H
#define N64_DECODE_H

#include "n64/passes.h"
#include "n64/polygons/rows.h"

enum n64_decode_constants {
    N64_DECODE_BITS = 15        /* columns_bits + rows_bits, at most: all that fits into TMEM,
                                   mirrored; 128 KB of texels, 2 MB of quads */
};

/* The neighbours in a decoded tile's quads: no quads; the next texels; or in s the ones after the
   next, for YUV's chroma, which two texels share. */
enum n64_quads { N64_QUADS_NONE, N64_QUADS_NEXT, N64_QUADS_CHROMA };

enum { N64_TILE_KEY = 3, N64_KEPT_KEY = N64_TILE_KEY + 3 };

/* Writes the N64_TILE_KEY longs of the cache key of a tile's texels, apart from TMEM and TLUT modes.
   An axis' edges are part of it only if it clamps: relative coordinates allow for the origin. */
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

/* What tiles are decoded with. */
struct n64_decoding {
    struct n64_decode_scratch *scratch;
    struct n64_colours *colours;
    int32 made;                 /* by n64_decode: 1 the tile was decoded, 0 it was already */
};

/* Makes *kept fit tile n, with quads or without, unless it does already. Memory is the system's and kept for the next time; a larger tile
   takes new memory, and what it had stays taken until the program ends. Colours are n64_fetch's;
   of a TLUT entry's four copies only the first counts (loads make them equal). YUV texels have
   U + 128 and V + 128 for R and G, Y for B and A; filters leave that as it is. */
enum n64_result n64_decode(struct n64_decoding *decoding, const struct n64 *n64, int32 n,
                           enum n64_quads quads, struct n64_kept *kept);

#endif
