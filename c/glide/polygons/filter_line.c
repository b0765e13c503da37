/* The bilinear filter over a line from texels, used if a level's quads, eight times as large, do
   not fit into memory. Results equal those of glide_bilinear and glide_bilinear_8. */
#include "glide/passes.h"

enum { FIELD = 0x00ff00ff };    /* every second channel of a texel */

/* The four texels around a place, R G B A. */
struct around {
    uint32 c00, c10, c01, c11;
};

/* s and t: texels, modulo the level. */
static void find_texels(struct around *around, const struct glide_decoded *level, uint32 s, uint32 t)
{
    const uint32 last_s = level->mask_s >> 4, last_t = level->mask_t >> 4;
    const uint32 *upper = level->texels + ((t & last_t) << level->columns_bits);
    const uint32 *lower = level->texels + (((t + 1) & last_t) << level->columns_bits);

    around->c00 = upper[s & last_s];
    around->c10 = upper[(s + 1) & last_s];
    around->c01 = lower[s & last_s];
    around->c11 = lower[(s + 1) & last_s];
}

/* Filters two channels in 16 bits each. No sum leaves its half, so differences may borrow. */
static uint32 pair(const struct around *c, int32 shift, uint32 fs, uint32 ft)
{
    const uint32 c00 = c->c00 >> shift & FIELD, c10 = c->c10 >> shift & FIELD;
    const uint32 c01 = c->c01 >> shift & FIELD, c11 = c->c11 >> shift & FIELD;
    const uint32 upper = (c00 << 4) + fs * (c10 - c00), lower = (c01 << 4) + fs * (c11 - c01);

    return (upper << 4) + ft * (lower - upper);
}

void glide_filter_line(const void *coordinates, void *texels, const void *decoded, int32 count)
{
    const uint32 *in = coordinates;
    struct around c;
    uint32 *out = texels;

    for (; count; count--, in++) {
        const uint32 fs = *in >> 16 & 15, ft = *in & 15;

        find_texels(&c, decoded, *in >> 20, (*in & 0xffff) >> 4);
        *out++ = (pair(&c, 8, fs, ft) & ~(uint32)FIELD) | (pair(&c, 0, fs, ft) >> 8 & FIELD);
    }
}

static uint32 channel(const struct around *c, int32 shift, uint32 fs, uint32 ft)
{
    const uint32 c00 = c->c00 >> shift & 255, c10 = c->c10 >> shift & 255;
    const uint32 c01 = c->c01 >> shift & 255, c11 = c->c11 >> shift & 255;
    const uint32 upper = (c00 << 8) + fs * (c10 - c00), lower = (c01 << 8) + fs * (c11 - c01);

    return (((upper << 8) + ft * (lower - upper)) >> 16 & 255) << shift;
}

void glide_filter_line_8(const void *coordinates, void *texels, const void *decoded, int32 count)
{
    const uint32 *in = coordinates;
    struct around c;
    uint32 *out = texels;

    for (; count; count--, in++) {
        const uint32 fs = *in >> 16 & 255, ft = *in & 255;

        find_texels(&c, decoded, *in >> 24, (*in & 0xffff) >> 8);
        *out++ = channel(&c, 24, fs, ft) | channel(&c, 16, fs, ft) | channel(&c, 8, fs, ft)
            | channel(&c, 0, fs, ft);
    }
}
