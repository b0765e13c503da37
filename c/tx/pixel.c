/* One pixel in one- and two-cycle mode. */
#include "tx/pixel.h"

void tx_sample_pixel(const struct tx *tx, const struct tx_point *point, struct tx_pixel *pixel)
{
    tx_project(tx, &point->at, &pixel->at);
    tx_level_of_point(tx, point, &pixel->at, &pixel->level);
    tx_sample(tx, pixel->level.tile0, pixel->at.s, pixel->at.t, 0, 0, &pixel->texel0);
    tx_sample(tx, pixel->level.tile1, pixel->at.s, pixel->at.t, 1, &pixel->texel0,
              &pixel->texel1);
}

uint32 tx_draw_pixel(const struct tx *tx, const struct tx_point *point,
                     const struct tx_colour *shade)
{
    static const struct tx_colour none;
    struct tx_divided at;
    struct tx_level level;
    struct tx_sources sources;

    tx_project(tx, &point->at, &at);
    level.tile0 = tx->primitive_tile;
    level.tile1 = tx->primitive_tile + 1;
    level.fraction = 0;
    if (tx->modes.lod || tx->inputs & TX_INPUT_LOD_FRACTION)
        tx_level_of_point(tx, point, &at, &level);
    sources.shade = shade ? *shade : none;
    sources.fraction = level.fraction;
    sources.texel0 = none;
    /* Cycle 1 may convert what cycle 0 sampled. */
    if (tx->inputs & (TX_INPUT_TEXEL0 | TX_INPUT_TEXEL1))
        tx_sample(tx, level.tile0, at.s, at.t, 0, 0, &sources.texel0);
    sources.texel1 = sources.texel0;
    if (tx->inputs & TX_INPUT_TEXEL1)
        tx_sample(tx, level.tile1, at.s, at.t, 1, &sources.texel0, &sources.texel1);
    return tx_combine_pixel(tx, &sources);
}
