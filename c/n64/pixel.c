/* One pixel in one- and two-cycle mode. */
#include "n64/pixel.h"

void n64_sample_pixel(const struct n64 *n64, const struct n64_point *point, struct n64_pixel *pixel)
{
    n64_project(n64, &point->at, &pixel->at);
    n64_level_of_point(n64, point, &pixel->at, &pixel->level);
    n64_sample(n64, pixel->level.tile0, pixel->at.s, pixel->at.t, 0, 0, &pixel->texel0);
    n64_sample(n64, pixel->level.tile1, pixel->at.s, pixel->at.t, 1, &pixel->texel0,
               &pixel->texel1);
}

uint32 n64_draw_pixel(const struct n64 *n64, const struct n64_point *point,
                      const struct n64_colour *shade)
{
    static const struct n64_colour none;
    struct n64_divided at;
    struct n64_level level;
    struct n64_sources sources;

    n64_project(n64, &point->at, &at);
    level.tile0 = n64->primitive_tile;
    level.tile1 = n64->primitive_tile + 1;
    level.fraction = 0;
    if (n64->modes.lod || n64->inputs & N64_INPUT_LOD_FRACTION)
        n64_level_of_point(n64, point, &at, &level);
    sources.shade = shade ? *shade : none;
    sources.fraction = level.fraction;
    sources.texel0 = none;
    /* Cycle 1 may convert cycle 0's sample. */
    if (n64->inputs & (N64_INPUT_TEXEL0 | N64_INPUT_TEXEL1))
        n64_sample(n64, level.tile0, at.s, at.t, 0, 0, &sources.texel0);
    sources.texel1 = sources.texel0;
    if (n64->inputs & N64_INPUT_TEXEL1)
        n64_sample(n64, level.tile1, at.s, at.t, 1, &sources.texel0, &sources.texel1);
    return n64_combine_pixel(n64, &sources);
}
