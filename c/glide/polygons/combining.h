/* What the combine unit comes to under a unit's modes: found once, not line by line. */
#ifndef GLIDE_COMBINING_H
#define GLIDE_COMBINING_H

#include "glide/pixel.h"

/* Of colour, or of alpha. m is the factor: 256 would be all, and 255 stands for it. */
enum glide_term {
    GLIDE_TERM_ANY,             /* none of those below, or 0 */
    GLIDE_TERM_ZERO,            /* of alpha alone */
    GLIDE_TERM_LOCAL,
    GLIDE_TERM_OTHER,
    GLIDE_TERM_SUM,             /* other + local */
    GLIDE_TERM_REST,            /* local - local m */
    GLIDE_TERM_SCALED,          /* other m */
    GLIDE_TERM_SCALED_SUM,      /* other m + local */
    GLIDE_TERM_PRODUCT,         /* the same two, m the same channel of local */
    GLIDE_TERM_PRODUCT_SUM,
    GLIDE_TERM_BLEND            /* (other - local) m + local */
};

enum glide_alpha_way {
    GLIDE_ALPHA_UNSEEN,         /* nobody wants it */
    GLIDE_ALPHA_ALIKE,          /* what makes colour makes alpha too */
    GLIDE_ALPHA_TAKEN,          /* 0, local's or other's */
    GLIDE_ALPHA_COMBINED        /* for itself */
};

enum glide_reads { GLIDE_READS_LOCAL = 1, GLIDE_READS_OTHER = 2, GLIDE_READS_OTHER_ALPHA = 4 };

struct glide_combining {
    uint8 rgb, alpha;           /* enum glide_term */
    uint8 alpha_way;
    uint8 reads;                /* enum glide_reads */
    uint32 inverted;            /* afterwards: 255 for each channel, R G B A, that is */
};

enum { GLIDE_UNKNOWN = -1 };

/* Factors that come from the level of detail, where they are the same for all pixels; GLIDE_UNKNOWN:
   they differ. flip: 255 where odd levels turn factors round, or else 0. */
struct glide_known {
    int32 detail, fraction, flip;
};

/* has_other: there is a unit upstream. has_alpha: somebody wants the alpha of the result. */
void glide_combining_find(struct glide_combining *to, const struct glide_modes *modes,
                          const struct glide_known *known, int32 has_other, int32 has_alpha);

/* Whether the unit's texels, or what comes from upstream, are all there is to do. */
static inline int32 glide_shows(const struct glide_combining *combining, enum glide_term term)
{
    return combining->rgb == term && combining->alpha_way <= GLIDE_ALPHA_ALIKE
        && !combining->inverted;
}

#endif
