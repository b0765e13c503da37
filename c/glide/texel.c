/* A texel's colour, by its format. */
#include "glide/pixel.h"

static uint32 pack(uint32 a, uint32 r, uint32 g, uint32 b)
{
    return a << 24 | r << 16 | g << 8 | b;
}

/* Returns `bits` bits of a texel from bit low on, widened to 8 by repeating them from the top. */
static uint32 widen(uint32 texel, uint32 low, uint32 bits)
{
    uint32 value = (texel >> low & ((1u << bits) - 1)) << (8 - bits);

    for (; bits < 8; bits <<= 1)
        value |= value >> bits;
    return value;
}

static uint32 cut(int32 value)
{
    return value < 0 ? 0 : value > 255 ? 255 : (uint32)value;
}

static uint32 decompress(const struct glide_ncc *table, uint32 texel, uint32 alpha)
{
    const int32 y = table->y[texel >> 4 & 15];
    const int16 *i = table->i[texel >> 2 & 3], *q = table->q[texel & 3];

    return pack(alpha, cut(y + i[0] + q[0]), cut(y + i[1] + q[1]), cut(y + i[2] + q[2]));
}

static uint32 rgb332(uint32 texel, uint32 alpha)
{
    return pack(alpha, widen(texel, 5, 3), widen(texel, 2, 3), widen(texel, 0, 2));
}

uint32 glide_colour(const struct glide *glide, uint32 texel)
{
    const uint32 low = texel & 255, high = texel >> 8;
    const struct glide_ncc *ncc = &glide->ncc[glide->modes.ncc_table];

    switch (glide->modes.format) {
    case GLIDE_RGB332: return rgb332(low, 255);
    case GLIDE_YIQ422: return decompress(ncc, low, 255);
    case GLIDE_A8: return pack(low, low, low, low);
    case GLIDE_I8: return pack(255, low, low, low);
    case GLIDE_AI44: return pack(widen(low, 4, 4), widen(low, 0, 4), widen(low, 0, 4),
                                 widen(low, 0, 4));
    case GLIDE_P8: return pack(255, 0, 0, 0) | glide->palette[low];
    case GLIDE_ARGB8332: return rgb332(low, high);
    case GLIDE_AYIQ8422: return decompress(ncc, low, high);
    case GLIDE_RGB565: return pack(255, widen(texel, 11, 5), widen(texel, 5, 6),
                                   widen(texel, 0, 5));
    case GLIDE_ARGB1555: return pack(widen(texel, 15, 1), widen(texel, 10, 5), widen(texel, 5, 5),
                                     widen(texel, 0, 5));
    case GLIDE_ARGB4444: return pack(widen(texel, 12, 4), widen(texel, 8, 4), widen(texel, 4, 4),
                                     widen(texel, 0, 4));
    case GLIDE_AI88: return pack(high, low, low, low);
    default: return pack(high, 0, 0, 0) | glide->palette[low];
    }
}

uint32 glide_texel(const struct glide *glide, const struct glide_level *level, uint32 i, uint32 j)
{
    const uint32 mask = glide->memory_bytes - 1, n = j * level->columns + i;
    const uint8 *memory = glide->memory;
    uint32 address = level->address + n;

    if (glide->modes.format < GLIDE_ARGB8332)
        return glide_colour(glide, memory[address & mask]);
    address += n;
    return glide_colour(glide, (uint32)memory[(address + 1) & mask] << 8 | memory[address & mask]);
}
