#include "tmu/pixel.h"

uint32 tmu_pixel(const struct tmu *tmu, const struct tmu_point *point, uint32 other)
{
    struct tmu_lod lod;
    int32 s, t;

    tmu_project(tmu, point, &s, &t);
    tmu_find_lod(tmu, point, &lod);
    return tmu_combine_pixel(tmu, &lod, tmu_sample(tmu, &lod, s, t), other);
}
