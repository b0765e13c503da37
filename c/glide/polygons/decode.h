/* Levels decoded ahead: the passes over a line's pixels read them instead of texture memory. */
#ifndef GLIDE_DECODE_H
#define GLIDE_DECODE_H

#include "glide/passes.h"
#include "glide/pixel.h"
#include "glide/polygons/lines.h"

enum { GLIDE_LEVEL_KEY = 5 };

/* A cached decoded level. All 0 before the first use. */
struct glide_kept {
    struct glide_decoded decoded;
    uint32 key[GLIDE_LEVEL_KEY];  /* cache key */
    uint32 *texels;
    void *quads;                /* as decoded.quads */
    uint32 texels_room, quads_room;     /* elements */
};

/* Makes *kept fit a unit's level, with quads for its weights or at least its texels, unless it does
   already; 0: memory is short. Memory is the system's and kept for the next time. */
int32 glide_decode(const struct glide *glide, uint32 level, int32 quads, struct glide_kept *kept,
                   struct glide_bytes *bytes);

#endif
