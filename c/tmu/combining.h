/* What the combine unit comes to under a unit's modes: found once, not line by line. */
#ifndef TMU_COMBINING_H
#define TMU_COMBINING_H

#include "tmu/pixel.h"

/* Of colour, or of alpha. m is the factor: 256 would be all, and 255 stands for it. */
enum tmu_term {
    TMU_TERM_ANY,               /* none of those below, or 0 */
    TMU_TERM_ZERO,              /* of alpha alone */
    TMU_TERM_LOCAL,
    TMU_TERM_OTHER,
    TMU_TERM_SUM,               /* other + local */
    TMU_TERM_REST,              /* local - local m */
    TMU_TERM_SCALED,            /* other m */
    TMU_TERM_SCALED_SUM,        /* other m + local */
    TMU_TERM_PRODUCT,           /* the same two, m the same channel of local */
    TMU_TERM_PRODUCT_SUM,
    TMU_TERM_BLEND              /* (other - local) m + local */
};

enum tmu_alpha_way {
    TMU_ALPHA_UNSEEN,           /* nobody wants it */
    TMU_ALPHA_ALIKE,            /* what makes colour makes alpha too */
    TMU_ALPHA_TAKEN,            /* 0, local's or other's */
    TMU_ALPHA_COMBINED          /* for itself */
};

enum tmu_reads { TMU_READS_LOCAL = 1, TMU_READS_OTHER = 2, TMU_READS_OTHER_ALPHA = 4 };

struct tmu_combining {
    uint8 rgb, alpha;           /* enum tmu_term */
    uint8 alpha_way;
    uint8 reads;                /* enum tmu_reads */
    uint32 inverted;            /* afterwards: 255 for each channel, R G B A, that is */
};

enum { TMU_UNKNOWN = -1 };

/* Factors that come from the level of detail, where they are the same for all pixels; TMU_UNKNOWN:
   they differ. flip: 255 where odd levels turn factors round, or else 0. */
struct tmu_known {
    int32 detail, fraction, flip;
};

/* has_other: there is a unit upstream. has_alpha: somebody wants the alpha of the result. */
void tmu_combining_find(struct tmu_combining *to, const struct tmu_modes *modes,
                        const struct tmu_known *known, int32 has_other, int32 has_alpha);

/* Whether the unit's texels, or what comes from upstream, are all there is to do. */
static inline int32 tmu_shows(const struct tmu_combining *combining, enum tmu_term term)
{
    return combining->rgb == term && combining->alpha_way <= TMU_ALPHA_ALIKE
        && !combining->inverted;
}

#endif
