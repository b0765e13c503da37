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

enum glide_result glide_chain_init(struct glide_chain *chain, struct glide *const *units, uint32 count)
{
    if (!count || count > GLIDE_UNITS)
        return GLIDE_BAD_UNITS;
    for (uint32 n = 0; n < count; n++)
        chain->units[n] = units[n];
    chain->count = count;
    chain->own = 0;
    return GLIDE_DONE;
}

enum glide_result glide_chain_hints(struct glide_chain *chain, uint32 own)
{
    if (own >> chain->count)
        return GLIDE_BAD_UNITS;
    chain->own = own;
    return GLIDE_DONE;
}

uint32 glide_chain_pixel(const struct glide_chain *chain, const struct glide_point *points)
{
    uint32 colour = 0;

    for (uint32 n = chain->count; n--;)
        colour = glide_pixel(chain->units[n], &points[chain->own >> n & 1 ? n : 0], colour);
    return colour;
}
