#include "glide/pixel.h"

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
