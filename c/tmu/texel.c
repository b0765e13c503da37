/* A texel's colour, by its format. */
#include "tmu/pixel.h"

static uint32 pack(uint32 a, uint32 r, uint32 g, uint32 b)
{
    return a << 24 | r << 16 | g << 8 | b;
}

/* Bits high to low of a texel as 8 bits: repeated from the top. */
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

static uint32 decompress(const struct tmu_ncc *table, uint32 texel, uint32 alpha)
{
    const int32 y = table->y[texel >> 4 & 15];
    const int16 *i = table->i[texel >> 2 & 3], *q = table->q[texel & 3];

    return pack(alpha, cut(y + i[0] + q[0]), cut(y + i[1] + q[1]), cut(y + i[2] + q[2]));
}

static uint32 rgb332(uint32 texel, uint32 alpha)
{
    return pack(alpha, widen(texel, 5, 3), widen(texel, 2, 3), widen(texel, 0, 2));
}

uint32 tmu_colour(const struct tmu *tmu, uint32 texel)
{
    const uint32 low = texel & 255, high = texel >> 8;
    const struct tmu_ncc *ncc = &tmu->ncc[tmu->modes.ncc_table];

    switch (tmu->modes.format) {
    case TMU_RGB332: return rgb332(low, 255);
    case TMU_YIQ422: return decompress(ncc, low, 255);
    case TMU_A8: return pack(low, low, low, low);
    case TMU_I8: return pack(255, low, low, low);
    case TMU_AI44: return pack(widen(low, 4, 4), widen(low, 0, 4), widen(low, 0, 4),
                               widen(low, 0, 4));
    case TMU_P8: return pack(255, 0, 0, 0) | tmu->palette[low];
    case TMU_ARGB8332: return rgb332(low, high);
    case TMU_AYIQ8422: return decompress(ncc, low, high);
    case TMU_RGB565: return pack(255, widen(texel, 11, 5), widen(texel, 5, 6),
                                 widen(texel, 0, 5));
    case TMU_ARGB1555: return pack(widen(texel, 15, 1), widen(texel, 10, 5), widen(texel, 5, 5),
                                   widen(texel, 0, 5));
    case TMU_ARGB4444: return pack(widen(texel, 12, 4), widen(texel, 8, 4), widen(texel, 4, 4),
                                   widen(texel, 0, 4));
    case TMU_AI88: return pack(high, low, low, low);
    default: return pack(high, 0, 0, 0) | tmu->palette[low];
    }
}

uint32 tmu_texel(const struct tmu *tmu, const struct tmu_level *level, uint32 i, uint32 j)
{
    const uint32 mask = tmu->memory_bytes - 1, n = j * level->columns + i;
    const uint8 *memory = tmu->memory;
    uint32 address = level->address + n;

    if (tmu->modes.format < TMU_ARGB8332)
        return tmu_colour(tmu, memory[address & mask]);
    address += n;
    return tmu_colour(tmu, (uint32)memory[(address + 1) & mask] << 8 | memory[address & mask]);
}
