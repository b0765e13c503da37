/* Decodes a tile's texels from TMEM, a whole row at a time. */
#include "n64/polygons/decode.h"

enum { LOW_HALF = N64_TMEM_BYTES / 2 - 1, ALL = N64_TMEM_BYTES - 1 };   /* masks of addresses */

static inline uint32 rgba16_colour(uint32 bits)
{
    const uint32 five = (bits & 0xf800) << 16 | (bits & 0x07c0) << 13 | (bits & 0x3e) << 10;

    return five | (five >> 5 & 0x07070700) | ((0 - (bits & 1)) & 255);
}

static inline uint32 ia16_colour(uint32 bits)
{
    return (bits >> 8) * 0x01010100u | (bits & 255);
}

/* Returns the IA 16 texel that equals a texel of 4 or 8 bits. */
static uint32 ia16_of(const struct n64_tile *tile, uint32 bits)
{
    if (tile->size == N64_8)
        return tile->format == N64_IA ? (bits >> 4) * 0x1100 | (bits & 15) * 17 : bits * 0x101;
    if (tile->format == N64_IA)
        return ((bits >> 1) * 0x2480 & 0xff00) | (bits & 1) * 255;
    return tile->format == N64_CI ? (tile->palette * 16u + bits) * 0x101 : bits * 0x1111;
}

static void make_colours(struct n64_colours *colours, const struct n64 *n64,
                         const struct n64_tile *tile)
{
    const uint32 is_rgba = n64->modes.tlut && !n64->modes.tlut_type;
    const uint32 count = tile->size == N64_4 ? 16 : 256;
    const uint32 first = tile->size == N64_4 ? tile->palette * 16u : 0;

    for (uint32 i = 0; i < count; i++) {
        const uint32 bits = n64->modes.tlut ? n64_tlut_entry(n64, first + i, 0) : ia16_of(tile, i);
        const uint32 from = is_rgba << 16 | bits;

        if (colours->from[i] != from) {
            colours->from[i] = from;
            colours->of[i] = is_rgba ? rgba16_colour(bits) : ia16_colour(bits);
        }
    }
}

/* Returns bytes of TMEM, or of one half of it, in order. They begin at address at (a multiple of 8)
   and wrap by mask. They are copied to room if they wrap or if the row is odd: odd rows have the
   longs of each word swapped. */
static const void *in_order(const uint8 *part, uint32 at, uint32 mask, int32 odd, int32 bytes,
                            uint32 *room)
{
    uint32 *to = room;

    at &= mask;
    if (!odd && at + (uint32)bytes <= mask + 1)
        return part + at;
    for (; bytes > 0; bytes -= 8, at += 8) {
        const uint32 *word = (const uint32 *)(part + (at & mask));

        *to++ = word[odd];
        *to++ = word[!odd];
    }
    return room;
}

static uint32 mask_of(const struct n64_rows *rows)
{
    return rows->n64->modes.tlut ? LOW_HALF : ALL;
}

static void decode_4(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                     int32 count)
{
    const uint32 *colours = rows->colours->of;
    const uint8 *from = in_order(rows->n64->tmem, at, mask_of(rows), odd, (count + 1) >> 1,
                                 rows->scratch->words);

    for (; count > 0; count -= 2) {
        const uint32 bits = *from++;

        *texels++ = colours[bits >> 4];
        *texels++ = colours[bits & 15];
    }
}

static void decode_8(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                     int32 count)
{
    const uint32 *colours = rows->colours->of;
    const uint8 *from = in_order(rows->n64->tmem, at, mask_of(rows), odd, count,
                                 rows->scratch->words);

    while (count-- > 0)
        *texels++ = colours[*from++];
}

static void decode_16(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                      int32 count)
{
    const uint16 *from = in_order(rows->n64->tmem, at, ALL, odd, 2 * count,
                                  rows->scratch->words);

    if (rows->tile->format == N64_RGBA)
        while (count-- > 0)
            *texels++ = rgba16_colour(*from++);
    else
        while (count-- > 0)
            *texels++ = ia16_colour(*from++);
}

static void decode_rgba32(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                          int32 count)
{
    const uint8 *tmem = rows->n64->tmem;
    const uint16 *rg = in_order(tmem, at, LOW_HALF, odd, 2 * count, rows->scratch->words);
    const uint16 *ba = in_order(tmem + LOW_HALF + 1, at, LOW_HALF, odd, 2 * count,
                                rows->scratch->words_high);

    while (count-- > 0)
        *texels++ = (uint32)*rg++ << 16 | *ba++;
}

static void decode_yuv(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                       int32 count)
{
    const uint8 *tmem = rows->n64->tmem;
    const int32 bytes = (count + 1) & ~1;
    const uint16 *uv = in_order(tmem, at, LOW_HALF, odd, bytes, rows->scratch->words);
    const uint8 *y = in_order(tmem + LOW_HALF + 1, at, LOW_HALF, odd, bytes,
                              rows->scratch->words_high);

    for (; count > 0; count -= 2) {
        const uint32 chroma = (uint32)*uv++ << 16;

        *texels++ = chroma | (uint32)y[0] << 8 | y[0];
        *texels++ = chroma | (uint32)y[1] << 8 | y[1];
        y += 2;
    }
}

void n64_rows_find(struct n64_rows *rows, const struct n64 *n64, const struct n64_tile *tile,
                   struct n64_decode_scratch *scratch, struct n64_colours *colours)
{
    rows->scratch = scratch;
    rows->colours = colours;
    rows->n64 = n64;
    rows->tile = tile;
    rows->decode = 0;
    if (tile->format == N64_YUV) {
        rows->decode = decode_yuv;
    } else if (tile->size <= N64_8) {
        rows->decode = tile->size == N64_4 ? decode_4 : decode_8;
        make_colours(colours, n64, tile);
    } else if (!n64->modes.tlut) {
        if (tile->size == N64_16 && (tile->format == N64_RGBA || tile->format == N64_IA))
            rows->decode = decode_16;
        else if (tile->format == N64_RGBA)
            rows->decode = decode_rgba32;
    }
}

uint32 n64_rows_texel(const struct n64_rows *rows, int32 s, int32 row)
{
    struct n64_colour texel;

    n64_fetch(rows->n64, rows->tile, s, row, 0, &texel);
    if (rows->tile->format == N64_YUV) {
        texel.r += 128;
        texel.g += 128;
    }
    return (uint32)texel.r << 24 | (uint32)texel.g << 16 | (uint32)texel.b << 8 | (uint32)texel.a;
}

void n64_rows_decode(const struct n64_rows *rows, int32 row, uint32 *texels, int32 count)
{
    const struct n64_tile *tile = rows->tile;

    if (rows->decode)
        rows->decode(rows, 8 * ((uint32)tile->line * (uint32)row + tile->tmem), row & 1, texels,
                     count);
    else
        for (int32 s = 0; s < count; s++)
            *texels++ = n64_rows_texel(rows, s, row);
}
