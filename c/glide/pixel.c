#include "glide/pixel.h"

uint32 glide_pixel(const struct glide *glide, const struct glide_point *point, uint32 other)
{
    int32 s, t;

    glide_project(glide, point, &s, &t);
    return glide_pixel_at(glide, point, s, t, other);
}

uint32 glide_pixel_at(const struct glide *glide, const struct glide_point *point, int32 s, int32 t,
                      uint32 other)
{
    struct glide_lod lod;

    glide_find_lod(glide, point, &lod);
    return glide_combine_pixel(glide, &lod, glide_sample(glide, &lod, s, t), other);
}
