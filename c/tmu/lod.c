#include "tmu/pixel.h"
#include "tmu/product.h"

#define LOD_ONE 256             /* 1.0 */

/* 1/16 LOD each. */
static const uint8 pattern[4][4] = {
    {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}
};

static struct number64 square(int32 value)
{
    return tmu_product(fix_magnitude(value), fix_magnitude(value));
}

int32 tmu_lod_base(int32 dsdx, int32 dtdx, int32 dsdy, int32 dtdy)
{
    struct number64 most = tmu_sum(square(dsdx), square(dtdx));
    const struct number64 y = tmu_sum(square(dsdy), square(dtdy));

    if (y.hi > most.hi || (y.hi == most.hi && y.lo > most.lo))
        most = y;
    if (!most.hi && !most.lo)
        return TMU_LOD_LEAST;
    /* The sum has 36 fraction bits. Its logarithm is rounded first, then halved towards 0: so
       the reference data have it. */
    return (tmu_logarithm(most.hi, most.lo) - 36 * LOD_ONE) / 2;
}

int32 tmu_dither(int32 x, int32 y)
{
    return pattern[y & 3][x & 3] * (LOD_ONE / 16);
}

/* Before it is clamped. */
static int32 unclamped(const struct tmu *tmu, const struct tmu_point *point)
{
    int32 lod = point->lod;

    if (tmu->modes.perspective) {
        /* A negative w counts as the positive one does: so the reference data have it. */
        if (!point->w)
            return TMU_LOD_MOST;
        lod -= tmu_logarithm(0, fix_magnitude(point->w)) - 30 * LOD_ONE;
    }
    lod += tmu->modes.lod_bias * (LOD_ONE / 4);
    if (tmu->modes.dither)
        lod += tmu_dither(point->x, point->y);
    return lod;
}

/* Of levels that are blended in by another unit, or in another pass, the next smaller one is
   drawn. */
static int32 is_drawn(const struct tmu_modes *modes, int32 level)
{
    return !(modes->split || modes->trilinear) || (level & 1) == modes->odd;
}

int32 tmu_lod_least(const struct tmu_modes *modes)
{
    return modes->lod_min * (LOD_ONE / 4);
}

int32 tmu_lod_most(const struct tmu_modes *modes)
{
    const int32 most = modes->lod_max * (LOD_ONE / 4);

    return most < TMU_LEVEL_LAST * LOD_ONE ? most : TMU_LEVEL_LAST * LOD_ONE;
}

void tmu_lod_at(const struct tmu_modes *modes, int32 value, struct tmu_lod *lod)
{
    int32 level = value / LOD_ONE;

    lod->value = value;
    lod->odd = level & 1;
    if (!is_drawn(modes, level) && level < TMU_LEVEL_LAST)
        level++;
    lod->level = (uint8)level;
    lod->filter = value == tmu_lod_least(modes) ? modes->magnify : modes->minify;
}

void tmu_find_lod(const struct tmu *tmu, const struct tmu_point *point, struct tmu_lod *lod)
{
    const struct tmu_modes *modes = &tmu->modes;
    const int32 least = tmu_lod_least(modes), most = tmu_lod_most(modes);
    int32 value = unclamped(tmu, point);

    if (value < least)
        value = least;
    if (value > most)
        value = most;
    tmu_lod_at(modes, value, lod);
}
