#include "glide/polygons/bands.h"
#include "polygon/key.h"

/* Returns non-zero if a half of the combine unit uses its factor. */
static int32 multiplies(const struct glide_combination *by)
{
    return !by->zero_other || by->sub_local;
}

static int32 asks_for(const struct glide_modes *modes, uint32 factor)
{
    return (multiplies(&modes->rgb) && modes->rgb.mselect == factor)
        || (multiplies(&modes->alpha) && modes->alpha.mselect == factor);
}

/* Returns non-zero if pixels are the colours from upstream times the filtered texels. */
static int32 is_times(const struct glide_modes *modes, const struct glide_band *band)
{
    const struct glide_combining *combining = &band->combining;

    return combining->rgb == GLIDE_TERM_PRODUCT && combining->alpha_way <= GLIDE_ALPHA_ALIKE
        && !combining->inverted && band->flip == (modes->rgb.reverse ? 0 : 255)
        && band->lod.filter == GLIDE_BILINEAR && modes->fraction_bits == 4;
}

static uint32 bits_of(const struct glide_combining *combining)
{
    return (uint32)combining->reads * GLIDE_NEEDS_OWN
        | (glide_shows(combining, GLIDE_TERM_LOCAL) ? GLIDE_IS_OWN : 0)
        | (glide_shows(combining, GLIDE_TERM_OTHER) ? GLIDE_IS_OTHER : 0);
}

/* Sets a band of the LODs from .. to. */
static void set_band(struct glide_band *band, const struct glide_modes *modes, int32 from, int32 to,
                     int32 has_other, int32 has_alpha)
{
    struct glide_known known;

    glide_lod_at(modes, from, &band->lod);
    known.detail = known.fraction = known.flip = 0;
    if (modes->trilinear && band->lod.odd && (multiplies(&modes->rgb) || multiplies(&modes->alpha)))
        known.flip = 255;
    if (asks_for(modes, GLIDE_FACTOR_DETAIL)) {
        known.detail = glide_detail_factor(modes, from);
        if (known.detail != glide_detail_factor(modes, to))
            known.detail = GLIDE_UNKNOWN;
    }
    if (asks_for(modes, GLIDE_FACTOR_LOD_FRACTION))
        known.fraction = from == to ? from & 255 : GLIDE_UNKNOWN;
    glide_combining_find(&band->combining, modes, &known, has_other, has_alpha);
    band->flip = (uint8)known.flip;
    band->bits = (uint8)(bits_of(&band->combining) | (is_times(modes, band) ? GLIDE_IS_TIMES : 0));
    if (known.detail == GLIDE_UNKNOWN)
        band->bits |= GLIDE_DETAILS_DIFFER;
    if (known.fraction == GLIDE_UNKNOWN)
        band->bits |= GLIDE_FRACTIONS_DIFFER;
    band->detail = (uint8)(known.detail == GLIDE_UNKNOWN ? 0 : known.detail);
    band->fraction = (uint8)(known.fraction == GLIDE_UNKNOWN ? 0 : known.fraction);
}

/* Returns other if it is above lod and below found, else found. */
static int32 nearer(int32 found, int32 other, int32 lod)
{
    return other > lod && other < found ? other : found;
}

/* Returns where the next band begins, at the latest at the greatest LOD. */
static int32 next_break(const struct glide_modes *modes, int32 lod)
{
    const int32 scale = modes->detail_scale, end = modes->detail_bias * GLIDE_LOD_ONE + 1;
    const int32 slope = modes->detail_max * GLIDE_LOD_ONE + (1 << scale) - 1;
    int32 found = (lod | (GLIDE_LOD_ONE - 1)) + 1;

    found = nearer(found, glide_lod_least(modes) + 1, lod);
    found = nearer(found, glide_lod_most(modes), lod);
    if (asks_for(modes, GLIDE_FACTOR_DETAIL)) {
        found = nearer(found, end - (GLIDE_LOD_ONE >> scale), lod);
        found = nearer(found, end - (slope >> scale), lod);
    }
    return found;
}

static int32 is_same(const struct glide_band *a, const struct glide_band *b)
{
    return a->lod.level == b->lod.level && a->lod.filter == b->lod.filter && a->flip == b->flip
        && a->detail == b->detail && a->fraction == b->fraction && a->bits == b->bits
        && a->combining.rgb == b->combining.rgb && a->combining.alpha == b->combining.alpha
        && a->combining.alpha_way == b->combining.alpha_way;
}

static void make_bands(struct glide_bands *bands, const struct glide_modes *modes,
                       int32 has_other, int32 has_alpha)
{
    const int32 least = glide_lod_least(modes), most = glide_lod_most(modes);
    int32 from = least < most ? least : most, next;

    bands->count = 0;
    for (; from <= most; from = next) {
        struct glide_band *band = &bands->of[bands->count];

        next = from < most ? next_break(modes, from) : most + 1;
        set_band(band, modes, from, next - 1, has_other, has_alpha);
        if (bands->count && is_same(band, band - 1))
            continue;
        bands->count++;
    }
}

void glide_bands_find(struct glide_bands *bands, const struct glide *glide, int32 has_other,
                      int32 has_alpha)
{
    uint32 key[GLIDE_BANDS_KEY];

    key[0] = (uint32)glide;
    key[1] = glide->mode_generation;
    key[2] = (uint32)(has_other << 1 | has_alpha);
    if (key_differs(bands->key, key, GLIDE_BANDS_KEY) || !bands->count)
        make_bands(bands, &glide->modes, has_other, has_alpha);
}
