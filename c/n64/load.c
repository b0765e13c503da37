/* Loads: from DRAM to TMEM, in chunks of 8 bytes. */
#include "n64/bits.h"
#include "n64/n64.h"

static void put_unit(struct n64 *n64, uint32 unit, uint32 first, uint32 second)
{
    uint8 *to = n64->tmem + 2 * unit;

    to[0] = (uint8)first;
    to[1] = (uint8)second;
}

/* Returns the 16-bit unit of texel s, counted from the beginning of the tile's row. */
static uint32 column_of(const struct n64_tile *tile, uint32 s)
{
    if (tile->size == N64_8 || tile->format == N64_YUV)
        return s >> 1;
    return tile->size == N64_4 ? s >> 2 : s;
}

/* Puts 8 bytes into a row at texel s: 16-bit units in order, the two longs swapped in odd rows.
   RGBA 32 and YUV put two units into each half of TMEM. */
static void put_chunk(struct n64 *n64, const struct n64_tile *tile, uint32 row, uint32 s,
                      const uint8 *d)
{
    const uint32 base = ((tile->line * row & 511) + tile->tmem) * 4;
    const uint32 odd = (row & 1) * 2;
    uint32 unit = base + column_of(tile, s);

    if (!n64_is_split(tile)) {
        unit &= 0x7fc;
        for (uint32 i = 0; i < 4; i++, d += 2)
            put_unit(n64, (unit + i) ^ odd, d[0], d[1]);
        return;
    }
    unit = ((unit & 0x7fe) ^ odd) & 0x3ff;
    if (tile->format == N64_YUV) {
        put_unit(n64, unit, d[0], d[2]);
        put_unit(n64, unit + 1, d[4], d[6]);
        put_unit(n64, unit + 0x400, d[1], d[3]);
        put_unit(n64, unit + 0x401, d[5], d[7]);
    } else {
        put_unit(n64, unit, d[0], d[1]);
        put_unit(n64, unit + 1, d[4], d[5]);
        put_unit(n64, unit + 0x400, d[2], d[3]);
        put_unit(n64, unit + 0x401, d[6], d[7]);
    }
}

/* Returns non-zero if the bytes are within DRAM, without a sum that could wrap. */
static int32 inside(const struct n64 *n64, uint32 from, uint32 bytes)
{
    return n64->dram && bytes <= n64->dram_bytes && from <= n64->dram_bytes - bytes;
}

/* Checks image and tile for both texel loads. */
static enum n64_result check_image(const struct n64 *n64, const struct n64_tile *tile)
{
    if (n64->image.size == N64_4)
        return N64_IMAGE_4_BIT;
    if (!n64->checked)
        return N64_DONE;
    if (n64->image.address & 7)
        return N64_IMAGE_MISALIGNED;
    if (tile->size != n64->image.size || !n64_loadable_pair(n64->image.format, n64->image.size)
        || !n64_loadable_pair(tile->format, tile->size))
        return N64_ILLEGAL_PAIR;
    return N64_DONE;
}

/* Checks that a load stays in the part of TMEM that the tile's texels may use. end: the TMEM word
   behind the last one. */
static enum n64_result check_room(const struct n64 *n64, const struct n64_tile *tile, uint32 end)
{
    if (!n64->checked)
        return N64_DONE;
    if (n64_is_split(tile)) {
        if (tile->tmem >= N64_HALF_WORDS)
            return N64_SPLIT_HIGH;
        return end > N64_HALF_WORDS ? N64_LOAD_TOO_LARGE : N64_DONE;
    }
    if (tile->format == N64_CI && (tile->tmem >= N64_HALF_WORDS || end > N64_HALF_WORDS))
        return N64_INDEX_HIGH;
    return end > N64_TMEM_WORDS ? N64_LOAD_TOO_LARGE : N64_DONE;
}

/* Returns the TMEM words that chunks take up from the beginning of a row: split ones take half. */
static uint32 words_of(const struct n64_tile *tile, uint32 chunks)
{
    return n64_is_split(tile) ? (chunks + 1) >> 1 : chunks;
}

/* What a load takes from the image: texels of each row (0: the last comes before the first), from
   column `left` and row `top` on. */
struct part {
    uint32 left, top, texels, rows;
    uint32 dxt;                 /* rows of TMEM a chunk, 1.11 */
};

static enum n64_result load_part(struct n64 *n64, uint32 hi, uint32 lo, const struct part *part)
{
    const struct n64_tile *tile = &n64->tiles[n64_bits(lo, 26, 24)];
    const uint32 texel_shift = n64->image.size - 1u, step = 16u >> n64->image.size;
    const uint32 chunks = (part->texels - 1 + step) / step;
    enum n64_result result = check_image(n64, tile);
    uint32 pitch, from;

    if (result != N64_DONE)
        return result;
    if (!part->texels) {
        if (n64->checked)
            return N64_LOAD_BACKWARDS;
        n64_set_edges(n64, hi, lo);
        return N64_DONE;
    }
    if (n64->checked && part->texels > N64_BLOCK_TEXELS)
        return N64_BLOCK_TOO_LARGE;
    result = check_room(n64, tile, tile->tmem + words_of(tile, chunks)
                        + (part->rows - 1 + ((chunks - 1) * part->dxt >> 11)) * tile->line);
    if (result != N64_DONE)
        return result;
    pitch = (uint32)n64->image.width << texel_shift;
    from = n64->image.address + part->top * pitch + (part->left << texel_shift);
    if (!inside(n64, from + (part->rows - 1) * pitch, 8 * chunks))
        return N64_OUTSIDE_DRAM;
    n64_set_edges(n64, hi, lo);
    for (uint32 row = 0; row < part->rows; row++) {
        const uint8 *at = n64->dram + from + row * pitch;
        uint32 way = row << 11;

        for (uint32 chunk = 0; chunk < chunks; chunk++, way += part->dxt, at += 8)
            put_chunk(n64, tile, way >> 11, chunk * step, at);
    }
    n64->tmem_generation++;
    return N64_DONE;
}

enum n64_result n64_load_tile_words(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 right = n64_bits(lo, 23, 14), bottom = n64_bits(lo, 11, 2);
    struct part part;

    part.left = n64_bits(hi, 23, 14);
    part.top = n64_bits(hi, 11, 2);
    part.rows = bottom - part.top + 1;
    part.texels = right < part.left || bottom < part.top ? 0 : right - part.left + 1;
    part.dxt = 0;
    return load_part(n64, hi, lo, &part);
}

enum n64_result n64_load_block_words(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 last = n64_bits(lo, 23, 12);
    struct part part;

    part.left = n64_bits(hi, 23, 12);
    part.top = n64_bits(hi, 11, 0);
    part.rows = 1;
    part.texels = last < part.left ? 0 : last - part.left + 1;
    part.dxt = n64_bits(lo, 11, 0);
    return load_part(n64, hi, lo, &part);
}

static enum n64_result check_tlut(const struct n64 *n64, const struct n64_tile *tile, uint32 entries)
{
    if (n64->image.size == N64_4)
        return N64_IMAGE_4_BIT;
    if (n64->image.size != N64_16)
        return N64_TLUT_IMAGE;
    if (!n64->checked)
        return N64_DONE;
    if (n64->image.address & 7)
        return N64_IMAGE_MISALIGNED;
    if (tile->size != N64_4)
        return N64_TLUT_TILE;
    if (tile->tmem < N64_HALF_WORDS)
        return N64_TLUT_LOW;
    if (entries > 256 || tile->tmem + entries > N64_TMEM_WORDS)
        return N64_TLUT_ENTRIES;
    return N64_DONE;
}

/* Each entry takes one word of TMEM and is in it four times. */
enum n64_result n64_load_tlut_words(struct n64 *n64, uint32 hi, uint32 lo)
{
    const struct n64_tile *tile = &n64->tiles[n64_bits(lo, 26, 24)];
    const uint32 first = n64_bits(hi, 23, 14), last = n64_bits(lo, 23, 14);
    const uint32 top = n64_bits(hi, 11, 2), entries = last - first + 1;
    enum n64_result result;
    uint32 from;

    if (n64_bits(lo, 11, 2) != top)
        return N64_TLUT_ROWS;
    if (last < first) {
        if (n64->checked)
            return N64_LOAD_BACKWARDS;
        n64_set_edges(n64, hi, lo);
        return N64_DONE;
    }
    result = check_tlut(n64, tile, entries);
    if (result != N64_DONE)
        return result;
    from = n64->image.address + 2 * (top * n64->image.width + first);
    if (!inside(n64, from, 2 * entries))
        return N64_OUTSIDE_DRAM;
    n64_set_edges(n64, hi, lo);
    for (uint32 i = 0; i < entries; i++) {
        const uint8 *entry = n64->dram + from + 2 * i;

        for (uint32 copy = 0; copy < 4; copy++)
            put_unit(n64, ((tile->tmem + i) * 4 + copy) & 0x7ff, entry[0], entry[1]);
    }
    n64->tmem_generation++;
    return N64_DONE;
}
