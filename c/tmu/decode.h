/* Levels decoded ahead: what the passes over a line's pixels read instead of texture memory. */
#ifndef TMU_DECODE_H
#define TMU_DECODE_H

#include "tmu/passes.h"
#include "tmu/pixel.h"

enum { TMU_LEVEL_KEY = 5 };

/* A decoded level that is kept. All 0 before the first use. */
struct tmu_kept {
    struct tmu_decoded decoded;
    uint32 key[TMU_LEVEL_KEY];  /* what it was made from */
    uint32 *texels;
    void *quads;                /* as decoded.quads */
    uint32 texels_room, quads_room;     /* elements */
};

/* Makes *kept fit a unit's level, with quads for its weights or at least its texels, unless it does
   already; 0: memory is short. Memory is the system's and kept for the next time. */
int32 tmu_decode(const struct tmu *tmu, uint32 level, int32 quads, struct tmu_kept *kept);

#endif
