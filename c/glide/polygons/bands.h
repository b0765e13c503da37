/* Bands of LODs: pixels with LODs in the same band are drawn by the same passes. */
#ifndef GLIDE_BANDS_H
#define GLIDE_BANDS_H

#include "glide/polygons/combining.h"

enum glide_bands_room {
    GLIDE_BANDS = 13,           /* begin at 0.0 to 8.0, above the least LOD, at the greatest, and
                                   where detail factors leave their maximum or reach 0 */
    GLIDE_BANDS_KEY = 3
};

/* What differs between a band's pixels, and their inputs. */
enum glide_band_bits {
    GLIDE_DETAILS_DIFFER = 1, GLIDE_FRACTIONS_DIFFER = 2,
    GLIDE_NEEDS_OWN = 4,        /* the unit's own texels; these three in the order of glide_reads */
    GLIDE_NEEDS_OTHER = 8,      /* the colours from upstream */
    GLIDE_NEEDS_OTHER_ALPHA = 16,
    GLIDE_IS_OWN = 32,          /* pixels are the own texels, unchanged, */
    GLIDE_IS_OTHER = 64,        /* or the colours from upstream */
    GLIDE_IS_TIMES = 128        /* or both, multiplied: see glide_times */
};

struct glide_band {
    struct glide_lod lod;       /* its first one */
    uint8 detail, fraction;     /* of all pixels; 0 if they differ or it is not used */
    uint8 flip;                 /* 255 if factors are inverted */
    uint8 bits;                 /* enum glide_band_bits */
    struct glide_combining combining;
};

/* In order, from the least LOD on. count is 0 before the first use. */
struct glide_bands {
    uint32 count;
    uint32 key[GLIDE_BANDS_KEY];  /* cache key */
    struct glide_band of[GLIDE_BANDS];
};

/* Makes a unit's bands, unless *bands has them already. has_other: there is a unit upstream;
   has_alpha: the result's alpha is used. */
void glide_bands_find(struct glide_bands *bands, const struct glide *glide, int32 has_other,
                      int32 has_alpha);

#endif
