/* Combines the unit's colour and the one from upstream. */
#include "glide/pixel.h"

/* Factors and alphas that all four channels can use. */
struct sources {
    int32 local_alpha, other_alpha, detail, fraction;
    int32 flip;                 /* 255 if the level is odd and inverts factors */
};

int32 glide_detail_factor(const struct glide_modes *modes, int32 lod)
{
    const int32 distance = modes->detail_bias * 256 - lod;
    const int32 factor = distance > 0 ? (distance << modes->detail_scale) >> 8 : 0;

    return factor < modes->detail_max ? factor : modes->detail_max;
}

static int32 factor(const struct glide_combination *combination, const struct sources *from,
                    int32 local)
{
    int32 m;

    switch (combination->mselect) {
    case GLIDE_FACTOR_LOCAL: m = local; break;
    case GLIDE_FACTOR_OTHER_ALPHA: m = from->other_alpha; break;
    case GLIDE_FACTOR_LOCAL_ALPHA: m = from->local_alpha; break;
    case GLIDE_FACTOR_DETAIL: m = from->detail; break;
    case GLIDE_FACTOR_LOD_FRACTION: m = from->fraction; break;
    default: m = 0;
    }
    return m ^ from->flip ^ (combination->reverse ? 0 : 255);
}

static uint32 channel(const struct glide_combination *combination, const struct sources *from,
                      int32 local, int32 other, int32 added)
{
    const int32 x = (combination->zero_other ? 0 : other) - (combination->sub_local ? local : 0);
    int32 y = ((x * (factor(combination, from, local) + 1)) >> 8) + added;

    y = y < 0 ? 0 : y > 255 ? 255 : y;
    return (uint32)(combination->invert ? 255 - y : y);
}

uint32 glide_combine_pixel(const struct glide *glide, const struct glide_lod *lod, uint32 local,
                           uint32 other)
{
    const struct glide_combination *rgb = &glide->modes.rgb, *alpha = &glide->modes.alpha;
    struct sources from;
    uint32 colour;

    from.local_alpha = (int32)(local >> 24);
    from.other_alpha = (int32)(other >> 24);
    from.detail = glide_detail_factor(&glide->modes, lod->value);
    from.fraction = lod->value & 255;
    from.flip = glide->modes.trilinear && lod->odd ? 255 : 0;
    colour = channel(alpha, &from, from.local_alpha, from.other_alpha,
                     alpha->add_local || alpha->add_alpha_local ? from.local_alpha : 0) << 24;
    for (int32 shift = 0; shift < 24; shift += 8) {
        const int32 own = (int32)(local >> shift & 255);

        colour |= channel(rgb, &from, own, (int32)(other >> shift & 255),
                          (rgb->add_local ? own : 0)
                          + (rgb->add_alpha_local ? from.local_alpha : 0)) << shift;
    }
    return colour;
}
