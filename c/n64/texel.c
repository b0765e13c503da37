/* Reads texels from TMEM. */
#include "n64/texel.h"

uint32 n64_texel_address(const struct n64_tile *tile, uint32 size, int32 s, int32 row)
{
    const uint32 at = 8 * ((uint32)tile->line * (uint32)row + tile->tmem);
    const uint32 offset = size == N64_4 ? (uint32)(s >> 1)
        : size == N64_8 ? (uint32)s : (uint32)s << 1;

    /* Odd rows have the two halves of each TMEM word swapped. */
    return ((at + offset) ^ (row & 1 ? 4 : 0)) & 0xfff;
}

uint32 n64_tlut_entry(const struct n64 *n64, uint32 index, int32 tap)
{
    const uint8 *entry = &n64->tmem[0x800 + 8 * index + 2 * (uint32)tap];

    return (uint32)entry[0] << 8 | entry[1];
}

uint32 n64_tlut_index(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row)
{
    const uint32 address = n64_texel_address(tile, tile->size, s, row) & 0x7ff;

    if (tile->size == N64_4)
        return tile->palette * 16u + (n64->tmem[address] >> (s & 1 ? 0 : 4) & 15);
    return n64->tmem[tile->size == N64_8 ? address : address & 0x7fe];
}

static int16 five(uint32 bits)
{
    bits &= 31;
    return (int16)(bits << 3 | bits >> 2);
}

static void expand_rgba16(uint32 bits, struct n64_colour *texel)
{
    texel->r = five(bits >> 11);
    texel->g = five(bits >> 6);
    texel->b = five(bits >> 1);
    texel->a = bits & 1 ? 255 : 0;
}

static void grey(uint32 value, uint32 alpha, struct n64_colour *texel)
{
    texel->r = texel->g = texel->b = (int16)value;
    texel->a = (int16)alpha;
}

static void fetch_4(const struct n64_tile *tile, uint32 nibble, struct n64_colour *texel)
{
    const uint32 i = nibble >> 1;

    if (tile->format == N64_IA)
        grey(i << 5 | i << 2 | i >> 1, nibble & 1 ? 255 : 0, texel);
    else if (tile->format == N64_CI)
        grey(tile->palette * 16u + nibble, tile->palette * 16u + nibble, texel);
    else
        grey(nibble * 17, nibble * 17, texel);
}

/* Of 16 or 32 bits. */
static void fetch_wide(const struct n64 *n64, const struct n64_tile *tile, uint32 address,
                       struct n64_colour *texel)
{
    const int32 split = tile->size == N64_32 && tile->format == N64_RGBA;
    const uint8 *at = &n64->tmem[address & (split ? 0x7fe : 0xffe)];

    if (tile->format == N64_RGBA && !split) {
        expand_rgba16((uint32)at[0] << 8 | at[1], texel);
    } else if (tile->format == N64_IA && tile->size == N64_16) {
        grey(at[0], at[1], texel);
    } else {
        texel->r = at[0];
        texel->g = at[1];
        texel->b = at[split ? 0x800 : 0];
        texel->a = at[split ? 0x801 : 1];
    }
}

/* U and V are in TMEM's low half, one of each for two texels; Y is in the high half. */
static void fetch_yuv(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row,
                      struct n64_colour *texel)
{
    const uint8 *uv = &n64->tmem[n64_texel_address(tile, N64_8, s & ~1, row) & 0x7fe];

    texel->r = (int16)(uv[0] - 128);
    texel->g = (int16)(uv[1] - 128);
    texel->b = texel->a = n64->tmem[0x800 | (n64_texel_address(tile, N64_8, s, row) & 0x7ff)];
}

void n64_fetch(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row, int32 tap,
               struct n64_colour *texel)
{
    uint32 address;

    if (tile->format == N64_YUV) {
        fetch_yuv(n64, tile, s, row, texel);
        return;
    }
    if (n64->modes.tlut) {
        address = n64_tlut_entry(n64, n64_tlut_index(n64, tile, s, row), tap);
        if (n64->modes.tlut_type)
            grey(address >> 8, address & 255, texel);
        else
            expand_rgba16(address, texel);
        return;
    }
    address = n64_texel_address(tile, tile->size, s, row);
    if (tile->size == N64_4)
        fetch_4(tile, n64->tmem[address] >> (s & 1 ? 0 : 4) & 15, texel);
    else if (tile->size == N64_8 && tile->format == N64_IA)
        grey((n64->tmem[address] >> 4) * 17u, (n64->tmem[address] & 15) * 17u, texel);
    else if (tile->size == N64_8)
        grey(n64->tmem[address], n64->tmem[address], texel);
    else
        fetch_wide(n64, tile, address, texel);
}
