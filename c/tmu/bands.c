#include "tmu/bands.h"

#define LOD_ONE 256             /* 1.0 */
#define UNKNOWN (-1)            /* a factor */

/* Whether a half of the combine unit multiplies anything. */
static int32 multiplies(const struct tmu_combination *by)
{
    return !by->zero_other || by->sub_local;
}

static int32 asks_for(const struct tmu_modes *modes, uint32 factor)
{
    return (multiplies(&modes->rgb) && modes->rgb.mselect == factor)
        || (multiplies(&modes->alpha) && modes->alpha.mselect == factor);
}

/* A half's factor in a band, if it is one only. */
static int32 factor_in(const struct tmu_combination *by, const struct tmu_band *band)
{
    const int32 flip = band->flip ^ (by->reverse ? 0 : 255);

    switch (by->mselect) {
    case TMU_FACTOR_LOCAL:
    case TMU_FACTOR_OTHER_ALPHA:
    case TMU_FACTOR_LOCAL_ALPHA:
        return UNKNOWN;
    case TMU_FACTOR_DETAIL:
        return band->bits & TMU_DETAILS_DIFFER ? UNKNOWN : band->detail ^ flip;
    case TMU_FACTOR_LOD_FRACTION:
        return band->bits & TMU_FRACTIONS_DIFFER ? UNKNOWN : band->fraction ^ flip;
    default:
        return flip;
    }
}

/* What a half is made of; own: how often its own channel is added to the product. Factor 255 leaves
   a difference as it is. 0 leaves 1/256, rounded down: 0 of what is not negative. */
static uint32 half_bits(const struct tmu_combination *by, const struct tmu_band *band, uint32 own,
                        uint32 alpha)
{
    const int32 factor = factor_in(by, band), is_whole = factor == 255;
    uint32 bits = 0;

    if (multiplies(by) && (by->mselect == TMU_FACTOR_LOCAL || by->mselect == TMU_FACTOR_LOCAL_ALPHA))
        bits |= TMU_NEEDS_OWN;
    if (alpha || (is_whole ? own != by->sub_local : own || by->sub_local))
        bits |= TMU_NEEDS_OWN;
    if (multiplies(by) && by->mselect == TMU_FACTOR_OTHER_ALPHA)
        bits |= TMU_NEEDS_OTHER;
    if (!by->zero_other && (factor || by->sub_local))
        bits |= TMU_NEEDS_OTHER;
    if (is_whole && !by->zero_other && !(bits & TMU_NEEDS_OWN) && !by->invert)
        bits |= TMU_IS_OTHER;
    return bits;
}

static uint32 needs(const struct tmu_modes *modes, const struct tmu_band *band)
{
    const struct tmu_combination *rgb = &modes->rgb, *alpha = &modes->alpha;
    const uint32 colour = half_bits(rgb, band, rgb->add_local, rgb->add_alpha_local);
    const uint32 rest = half_bits(alpha, band, alpha->add_local || alpha->add_alpha_local, 0);

    return ((colour | rest) & ~(uint32)TMU_IS_OTHER) | (colour & rest & TMU_IS_OTHER);
}

/* A band from one LOD to another. */
static void set_band(struct tmu_band *band, const struct tmu_modes *modes, int32 from, int32 to)
{
    const int32 detail = tmu_detail_factor(modes, from);

    tmu_lod_at(modes, from, &band->lod);
    band->detail = band->fraction = band->bits = 0;
    band->flip = modes->trilinear && band->lod.odd
        && (multiplies(&modes->rgb) || multiplies(&modes->alpha)) ? 255 : 0;
    if (asks_for(modes, TMU_FACTOR_DETAIL)) {
        if (detail == tmu_detail_factor(modes, to))
            band->detail = (uint8)detail;
        else
            band->bits |= TMU_DETAILS_DIFFER;
    }
    if (asks_for(modes, TMU_FACTOR_LOD_FRACTION)) {
        if (from == to)
            band->fraction = (uint8)from;
        else
            band->bits |= TMU_FRACTIONS_DIFFER;
    }
    band->bits |= (uint8)needs(modes, band);
}

/* The nearest of two that lies beyond a LOD. */
static int32 nearer(int32 found, int32 other, int32 lod)
{
    return other > lod && other < found ? other : found;
}

/* Where the next band begins, the most at the latest. */
static int32 next_break(const struct tmu_modes *modes, int32 lod)
{
    const int32 scale = modes->detail_scale, end = modes->detail_bias * LOD_ONE + 1;
    int32 found = (lod | (LOD_ONE - 1)) + 1;

    found = nearer(found, tmu_lod_least(modes) + 1, lod);
    found = nearer(found, tmu_lod_most(modes), lod);
    if (asks_for(modes, TMU_FACTOR_DETAIL)) {
        found = nearer(found, end - (LOD_ONE >> scale), lod);
        found = nearer(found, end - ((modes->detail_max * LOD_ONE + (1 << scale) - 1) >> scale), lod);
    }
    return found;
}

static int32 is_same(const struct tmu_band *a, const struct tmu_band *b)
{
    return a->lod.level == b->lod.level && a->lod.filter == b->lod.filter && a->flip == b->flip
        && a->detail == b->detail && a->fraction == b->fraction && a->bits == b->bits;
}

static void make_bands(struct tmu_bands *bands, const struct tmu_modes *modes)
{
    const int32 least = tmu_lod_least(modes), most = tmu_lod_most(modes);
    int32 from = least < most ? least : most, next;

    bands->count = bands->bits = 0;
    bands->every = ~(uint32)0;
    for (; from <= most; from = next) {
        struct tmu_band *band = &bands->of[bands->count];

        next = from < most ? next_break(modes, from) : most + 1;
        set_band(band, modes, from, next - 1);
        if (bands->count && is_same(band, band - 1))
            continue;
        bands->count++;
        bands->bits |= band->bits;
        bands->every &= band->bits;
    }
}

void tmu_bands_find(struct tmu_bands *bands, const struct tmu *tmu)
{
    uint32 key[TMU_BANDS_KEY], differs = !bands->count;

    key[0] = (uint32)tmu;
    key[1] = tmu->mode_generation;
    for (int32 i = 0; i < TMU_BANDS_KEY; i++) {
        differs |= key[i] ^ bands->key[i];
        bands->key[i] = key[i];
    }
    if (differs)
        make_bands(bands, &tmu->modes);
}
