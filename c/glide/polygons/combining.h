/* The operations that a unit's modes need of the combine unit, found once, not line by line. */
#ifndef GLIDE_COMBINING_H
#define GLIDE_COMBINING_H

#include "glide/pixel.h"

/* Operations for colour or alpha. m is the factor: 256 would be 1.0, and 255 counts as that. */
enum glide_term {
    GLIDE_TERM_ANY,             /* none of those below, or 0 */
    GLIDE_TERM_ZERO,            /* only for alpha */
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
    GLIDE_ALPHA_UNSEEN,         /* not used */
    GLIDE_ALPHA_ALIKE,          /* made together with colour */
    GLIDE_ALPHA_TAKEN,          /* 0, local's or other's */
    GLIDE_ALPHA_COMBINED        /* combined separately */
};

enum glide_reads { GLIDE_READS_LOCAL = 1, GLIDE_READS_OTHER = 2, GLIDE_READS_OTHER_ALPHA = 4 };

struct glide_combining {
    uint8 rgb, alpha;           /* enum glide_term */
    uint8 alpha_way;
    uint8 reads;                /* enum glide_reads */
    uint32 inverted;            /* R G B A: 255 for each channel to invert afterwards */
};

enum { GLIDE_UNKNOWN = -1 };

/* Factors from the level of detail, if they are the same for all pixels; GLIDE_UNKNOWN: they
   differ. flip: 255 if the level is odd and inverts factors, else 0. */
struct glide_known {
    int32 detail, fraction, flip;
};

/* has_other: there is a unit upstream. has_alpha: the result's alpha is used. */
void glide_combining_find(struct glide_combining *to, const struct glide_modes *modes,
                          const struct glide_known *known, int32 has_other, int32 has_alpha);

/* Returns non-zero if the result is just the unit's texels (GLIDE_TERM_LOCAL) or just the colours
   from upstream (GLIDE_TERM_OTHER). */
static inline int32 glide_shows(const struct glide_combining *combining, enum glide_term term)
{
    return combining->rgb == term && combining->alpha_way <= GLIDE_ALPHA_ALIKE
        && !combining->inverted;
}

#endif
