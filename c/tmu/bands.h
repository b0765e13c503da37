/* Bands of LODs: all pixels whose LODs lie in one are drawn by the same passes. */
#ifndef TMU_BANDS_H
#define TMU_BANDS_H

#include "tmu/combining.h"

enum tmu_bands_room {
    TMU_BANDS = 13,             /* begin at 0.0 to 8.0, above the least LOD, at the most, and where
                                   the detail factor leaves its maximum and reaches 0 */
    TMU_BANDS_KEY = 3
};

/* What of a band's pixels differs, and what they are made of. */
enum tmu_band_bits {
    TMU_DETAILS_DIFFER = 1, TMU_FRACTIONS_DIFFER = 2,
    TMU_NEEDS_OWN = 4,          /* the unit's own texels */
    TMU_NEEDS_OTHER = 8,        /* what comes from upstream */
    TMU_NEEDS_OTHER_ALPHA = 16,
    TMU_IS_OWN = 32,            /* they are just the one, */
    TMU_IS_OTHER = 64           /* or the other */
};

struct tmu_band {
    struct tmu_lod lod;         /* its first one */
    uint8 detail, fraction;     /* of all; 0 where the unit does not ask for it, or they differ */
    uint8 flip;                 /* 255 where factors are turned round */
    uint8 bits;                 /* enum tmu_band_bits */
    struct tmu_combining combining;
};

/* From the least LOD on. count is 0 before the first use. */
struct tmu_bands {
    uint32 count;
    uint32 key[TMU_BANDS_KEY];  /* what they were made from */
    struct tmu_band of[TMU_BANDS];
};

/* Makes *bands fit a unit's modes, unless they do already. has_other: there is a unit upstream;
   has_alpha: somebody wants the alpha of the result. */
void tmu_bands_find(struct tmu_bands *bands, const struct tmu *tmu, int32 has_other,
                    int32 has_alpha);

#endif
