/* Bands of LODs: all pixels whose LODs lie in one are drawn by the same passes. */
#ifndef GLIDE_BANDS_H
#define GLIDE_BANDS_H

#include "glide/polygons/combining.h"

enum glide_bands_room {
    GLIDE_BANDS = 13,           /* begin at 0.0 to 8.0, above the least LOD, at the most, and where
                                   the detail factor leaves its maximum and reaches 0 */
    GLIDE_BANDS_KEY = 3
};

/* What of a band's pixels differs, and what they are made of. */
enum glide_band_bits {
    GLIDE_DETAILS_DIFFER = 1, GLIDE_FRACTIONS_DIFFER = 2,
    GLIDE_NEEDS_OWN = 4,        /* the unit's own texels */
    GLIDE_NEEDS_OTHER = 8,      /* what comes from upstream */
    GLIDE_NEEDS_OTHER_ALPHA = 16,
    GLIDE_IS_OWN = 32,          /* they are just the one, */
    GLIDE_IS_OTHER = 64         /* or the other */
};

struct glide_band {
    struct glide_lod lod;       /* its first one */
    uint8 detail, fraction;     /* of all; 0 where the unit does not ask for it, or they differ */
    uint8 flip;                 /* 255 where factors are turned round */
    uint8 bits;                 /* enum glide_band_bits */
    struct glide_combining combining;
};

/* From the least LOD on. count is 0 before the first use. */
struct glide_bands {
    uint32 count;
    uint32 key[GLIDE_BANDS_KEY];  /* what they were made from */
    struct glide_band of[GLIDE_BANDS];
};

/* Makes *bands fit a unit's modes, unless they do already. has_other: there is a unit upstream;
   has_alpha: somebody wants the alpha of the result. */
void glide_bands_find(struct glide_bands *bands, const struct glide *glide, int32 has_other,
                      int32 has_alpha);

#endif
