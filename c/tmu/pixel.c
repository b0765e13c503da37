#include "tmu/pixel.h"

uint32 tmu_pixel(const struct tmu *tmu, const struct tmu_point *point, uint32 other)
{
    int32 s, t;

    tmu_project(tmu, point, &s, &t);
    return tmu_pixel_at(tmu, point, s, t, other);
}

uint32 tmu_pixel_at(const struct tmu *tmu, const struct tmu_point *point, int32 s, int32 t,
                    uint32 other)
{
    struct tmu_lod lod;

    tmu_find_lod(tmu, point, &lod);
    return tmu_combine_pixel(tmu, &lod, tmu_sample(tmu, &lod, s, t), other);
}
