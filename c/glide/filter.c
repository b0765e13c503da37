/* Point sampling and bilinear filtering of a level. */
#include "glide/pixel.h"

/* Wraps or clamps texels i and i + 1 of a side. */
static void wrap(int32 i, uint32 size, int32 clamp, uint32 *pair)
{
    for (int32 n = 0; n < 2; n++, i++) {
        if (!clamp)
            pair[n] = (uint32)i & (size - 1);
        else
            pair[n] = i < 0 ? 0 : i >= (int32)size ? size - 1 : (uint32)i;
    }
}

/* The level's texels are 2^(18 + level) apart. */
uint32 glide_sample(const struct glide *glide, const struct glide_lod *lod, int32 s, int32 t)
{
    const struct glide_modes *modes = &glide->modes;
    const int32 bits = lod->filter == GLIDE_BILINEAR ? modes->fraction_bits : 0;
    const int32 one = 1 << bits, half = one >> 1;
    const int32 u = (s >> (18 - bits + lod->level)) - half;
    const int32 v = (t >> (18 - bits + lod->level)) - half;
    const uint32 right = (uint32)(u & (one - 1)), down = (uint32)(v & (one - 1));
    const uint32 left = (uint32)one - right, up = (uint32)one - down;
    struct glide_level level;
    uint32 i[2], j[2], taps[4], colour = 0;

    glide_find_level(modes, lod->level, &level);
    wrap(u >> bits, level.columns, modes->clamp_s, i);
    wrap(v >> bits, level.rows, modes->clamp_t, j);
    if (lod->filter != GLIDE_BILINEAR)
        return glide_texel(glide, &level, i[0], j[0]);
    for (int32 n = 0; n < 4; n++)
        taps[n] = glide_texel(glide, &level, i[n & 1], j[n >> 1]);
    for (int32 shift = 0; shift < 32; shift += 8) {
        const uint32 upper = (taps[0] >> shift & 255) * left + (taps[1] >> shift & 255) * right;
        const uint32 lower = (taps[2] >> shift & 255) * left + (taps[3] >> shift & 255) * right;

        colour |= (upper * up + lower * down) >> (2 * bits) << shift;
    }
    return colour;
}
