#include "glide/polygons/combining.h"

/* Half of the combine unit (colour or alpha), reduced to the values that choose its term. */
struct half {
    const struct glide_combination *by;
    int32 is_alpha;
    int32 other;                /* 1: other is not 0 */
    uint32 factor;              /* the selected one: 1 to 5, 0 none */
    int32 is_whole;             /* m is 256 everywhere */
};

/* Returns the factor of all pixels, or -1 if it differs. */
static int32 factor_of(const struct half *half, const struct glide_known *known)
{
    int32 m = 0;

    switch (half->factor) {
    case 0: break;
    case GLIDE_FACTOR_DETAIL: m = known->detail; break;
    case GLIDE_FACTOR_LOD_FRACTION: m = known->fraction; break;
    default: return -1;
    }
    return m < 0 || known->flip < 0 ? -1 : m ^ known->flip ^ (half->by->reverse ? 0 : 255);
}

/* In the alpha half two factors mean local alpha; `own` is the one to use. */
static void open_half(struct half *half, const struct glide_combination *by,
                      const struct glide_known *known, int32 has_other, int32 is_alpha, uint32 own)
{
    int32 value;

    half->by = by;
    half->is_alpha = is_alpha;
    half->other = has_other && !by->zero_other;
    half->factor = by->mselect > GLIDE_FACTOR_LOD_FRACTION
        || (by->mselect == GLIDE_FACTOR_OTHER_ALPHA && !has_other) ? 0 : by->mselect;
    if (is_alpha && (half->factor == GLIDE_FACTOR_LOCAL || half->factor == GLIDE_FACTOR_LOCAL_ALPHA))
        half->factor = own;
    value = factor_of(half, known);
    half->is_whole = value == 255;
    if (!value && !by->sub_local)       /* other * 1 / 256 is 0 */
        half->other = 0;
}

/* Returns the term of (other - local) m + local, or without + local if adds is 0. */
static enum glide_term difference(const struct half *half, int32 adds)
{
    if (!adds)
        return half->other ? GLIDE_TERM_ANY : GLIDE_TERM_ZERO;
    if (half->is_whole)
        return half->other ? GLIDE_TERM_OTHER : GLIDE_TERM_ZERO;
    if (half->factor == GLIDE_FACTOR_LOCAL)
        return GLIDE_TERM_ANY;
    return half->other ? GLIDE_TERM_BLEND : GLIDE_TERM_REST;
}

static enum glide_term find_term(const struct half *half)
{
    const struct glide_combination *by = half->by;
    const int32 adds = by->add_local || (half->is_alpha && by->add_alpha_local);

    if (by->add_alpha_local && !half->is_alpha)
        return GLIDE_TERM_ANY;
    if (by->sub_local)
        return difference(half, adds);
    if (!half->other)
        return adds ? GLIDE_TERM_LOCAL : GLIDE_TERM_ZERO;
    if (half->is_whole)
        return adds ? GLIDE_TERM_SUM : GLIDE_TERM_OTHER;
    if (half->factor == GLIDE_FACTOR_LOCAL)
        return adds ? GLIDE_TERM_PRODUCT_SUM : GLIDE_TERM_PRODUCT;
    return adds ? GLIDE_TERM_SCALED_SUM : GLIDE_TERM_SCALED;
}

static int32 has_factor(enum glide_term term)
{
    return term >= GLIDE_TERM_REST || term == GLIDE_TERM_ANY;
}

static uint32 reads_of(const struct half *half, enum glide_term term)
{
    static const uint8 texels[] = {
        GLIDE_READS_LOCAL | GLIDE_READS_OTHER, 0, GLIDE_READS_LOCAL, GLIDE_READS_OTHER,
        GLIDE_READS_LOCAL | GLIDE_READS_OTHER, GLIDE_READS_LOCAL, GLIDE_READS_OTHER,
        GLIDE_READS_LOCAL | GLIDE_READS_OTHER, GLIDE_READS_LOCAL | GLIDE_READS_OTHER,
        GLIDE_READS_LOCAL | GLIDE_READS_OTHER, GLIDE_READS_LOCAL | GLIDE_READS_OTHER
    };
    uint32 reads = texels[term];

    if (reads & GLIDE_READS_OTHER && half->is_alpha)
        reads |= GLIDE_READS_OTHER_ALPHA;
    if (has_factor(term) && half->factor == GLIDE_FACTOR_OTHER_ALPHA)
        reads |= GLIDE_READS_OTHER | GLIDE_READS_OTHER_ALPHA;
    if (has_factor(term) && half->factor == GLIDE_FACTOR_LOCAL_ALPHA)
        reads |= GLIDE_READS_LOCAL;
    return reads;
}

static int32 is_alike(const struct half *rgb, enum glide_term term, const struct half *alpha,
                      enum glide_term other)
{
    return term == other && term != GLIDE_TERM_ANY
        && (!has_factor(term)
            || (rgb->factor == alpha->factor && rgb->by->reverse == alpha->by->reverse));
}

static void add_alpha(struct glide_combining *to, const struct half *rgb, const struct half *alpha)
{
    const enum glide_term term = find_term(alpha);

    to->alpha = (uint8)term;
    to->reads |= (uint8)reads_of(alpha, term);
    to->alpha_way = is_alike(rgb, to->rgb, alpha, term) ? GLIDE_ALPHA_ALIKE
        : term == GLIDE_TERM_ZERO || term == GLIDE_TERM_LOCAL || term == GLIDE_TERM_OTHER
        ? GLIDE_ALPHA_TAKEN : GLIDE_ALPHA_COMBINED;
    if (to->alpha_way != GLIDE_ALPHA_COMBINED && alpha->by->invert)
        to->inverted |= 255;
}

void glide_combining_find(struct glide_combining *to, const struct glide_modes *modes,
                          const struct glide_known *known, int32 has_other, int32 has_alpha)
{
    struct half rgb, alpha;
    enum glide_term term;

    open_half(&rgb, &modes->rgb, known, has_other, 0, 0);
    term = find_term(&rgb);
    if (term == GLIDE_TERM_ZERO)
        term = GLIDE_TERM_ANY;
    to->rgb = (uint8)term;
    to->reads = (uint8)reads_of(&rgb, term);
    to->inverted = term != GLIDE_TERM_ANY && modes->rgb.invert ? 0xffffff00 : 0;
    to->alpha = GLIDE_TERM_ANY;
    to->alpha_way = GLIDE_ALPHA_UNSEEN;
    if (has_alpha) {
        open_half(&alpha, &modes->alpha, known, has_other, 1, rgb.factor == GLIDE_FACTOR_LOCAL
                  ? GLIDE_FACTOR_LOCAL : GLIDE_FACTOR_LOCAL_ALPHA);
        add_alpha(to, &rgb, &alpha);
    }
    if (!has_other)
        to->reads &= GLIDE_READS_LOCAL;
}
