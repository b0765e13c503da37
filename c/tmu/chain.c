#include "tmu/pixel.h"

enum tmu_result tmu_chain_init(struct tmu_chain *chain, struct tmu *const *units, uint32 count)
{
    if (!count || count > TMU_UNITS)
        return TMU_BAD_UNITS;
    for (uint32 n = 0; n < count; n++)
        chain->units[n] = units[n];
    chain->count = count;
    chain->own = 0;
    return TMU_DONE;
}

enum tmu_result tmu_chain_hints(struct tmu_chain *chain, uint32 own)
{
    if (own >> chain->count)
        return TMU_BAD_UNITS;
    chain->own = own;
    return TMU_DONE;
}

uint32 tmu_chain_pixel(const struct tmu_chain *chain, const struct tmu_point *points)
{
    uint32 colour = 0;

    for (uint32 n = chain->count; n--;)
        colour = tmu_pixel(chain->units[n], &points[chain->own >> n & 1 ? n : 0], colour);
    return colour;
}
