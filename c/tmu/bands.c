#include "polygon/key.h"
#include "tmu/bands.h"

#define LOD_ONE 256             /* 1.0 */

/* What others leave and ask for. */
struct tmu_wanted {
    int32 has_other, has_alpha;
};

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

static uint32 bits_of(const struct tmu_combining *combining)
{
    uint32 bits = 0;

    if (combining->reads & TMU_READS_LOCAL)
        bits |= TMU_NEEDS_OWN;
    if (combining->reads & TMU_READS_OTHER)
        bits |= TMU_NEEDS_OTHER;
    if (combining->reads & TMU_READS_OTHER_ALPHA)
        bits |= TMU_NEEDS_OTHER_ALPHA;
    if (tmu_shows(combining, TMU_TERM_LOCAL))
        bits |= TMU_IS_OWN;
    if (tmu_shows(combining, TMU_TERM_OTHER))
        bits |= TMU_IS_OTHER;
    return bits;
}

/* A band from one LOD to another. */
static void set_band(struct tmu_band *band, const struct tmu_modes *modes, int32 from, int32 to,
                     const struct tmu_wanted *wanted)
{
    struct tmu_known known;

    tmu_lod_at(modes, from, &band->lod);
    known.detail = known.fraction = known.flip = 0;
    if (modes->trilinear && band->lod.odd && (multiplies(&modes->rgb) || multiplies(&modes->alpha)))
        known.flip = 255;
    if (asks_for(modes, TMU_FACTOR_DETAIL)) {
        known.detail = tmu_detail_factor(modes, from);
        if (known.detail != tmu_detail_factor(modes, to))
            known.detail = TMU_UNKNOWN;
    }
    if (asks_for(modes, TMU_FACTOR_LOD_FRACTION))
        known.fraction = from == to ? from & 255 : TMU_UNKNOWN;
    tmu_combining_find(&band->combining, modes, &known, wanted->has_other, wanted->has_alpha);
    band->bits = (uint8)bits_of(&band->combining);
    if (known.detail == TMU_UNKNOWN)
        band->bits |= TMU_DETAILS_DIFFER;
    if (known.fraction == TMU_UNKNOWN)
        band->bits |= TMU_FRACTIONS_DIFFER;
    band->detail = (uint8)(known.detail == TMU_UNKNOWN ? 0 : known.detail);
    band->fraction = (uint8)(known.fraction == TMU_UNKNOWN ? 0 : known.fraction);
    band->flip = (uint8)known.flip;
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
    const int32 slope = modes->detail_max * LOD_ONE + (1 << scale) - 1;
    int32 found = (lod | (LOD_ONE - 1)) + 1;

    found = nearer(found, tmu_lod_least(modes) + 1, lod);
    found = nearer(found, tmu_lod_most(modes), lod);
    if (asks_for(modes, TMU_FACTOR_DETAIL)) {
        found = nearer(found, end - (LOD_ONE >> scale), lod);
        found = nearer(found, end - (slope >> scale), lod);
    }
    return found;
}

static int32 is_same(const struct tmu_band *a, const struct tmu_band *b)
{
    return a->lod.level == b->lod.level && a->lod.filter == b->lod.filter && a->flip == b->flip
        && a->detail == b->detail && a->fraction == b->fraction && a->bits == b->bits
        && a->combining.rgb == b->combining.rgb && a->combining.alpha == b->combining.alpha
        && a->combining.alpha_way == b->combining.alpha_way;
}

static void make_bands(struct tmu_bands *bands, const struct tmu_modes *modes,
                       const struct tmu_wanted *wanted)
{
    const int32 least = tmu_lod_least(modes), most = tmu_lod_most(modes);
    int32 from = least < most ? least : most, next;

    bands->count = 0;
    for (; from <= most; from = next) {
        struct tmu_band *band = &bands->of[bands->count];

        next = from < most ? next_break(modes, from) : most + 1;
        set_band(band, modes, from, next - 1, wanted);
        if (bands->count && is_same(band, band - 1))
            continue;
        bands->count++;
    }
}

void tmu_bands_find(struct tmu_bands *bands, const struct tmu *tmu, int32 has_other,
                    int32 has_alpha)
{
    uint32 key[TMU_BANDS_KEY];
    struct tmu_wanted wanted;

    wanted.has_other = has_other;
    wanted.has_alpha = has_alpha;
    key[0] = (uint32)tmu;
    key[1] = tmu->mode_generation;
    key[2] = (uint32)(has_other << 1 | has_alpha);
    if (key_differs(bands->key, key, TMU_BANDS_KEY) || !bands->count)
        make_bands(bands, &tmu->modes, &wanted);
}
