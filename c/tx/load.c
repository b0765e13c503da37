/* Loads: from DRAM to TMEM, in chunks of 8 bytes. */
#include "tx/bits.h"
#include "tx/tx.h"

/* Two bytes to a 16-bit unit of TMEM. */
static void put_unit(struct tx *tx, uint32 unit, uint32 first, uint32 second)
{
    uint8 *to = tx->tmem + 2 * unit;

    to[0] = (uint8)first;
    to[1] = (uint8)second;
}

static int32 is_split(const struct tx_tile *tile)
{
    return tile->format == TX_YUV || (tile->format == TX_RGBA && tile->size == TX_32);
}

/* The 16-bit unit, from the row's beginning on, that texel s of a tile is in. */
static uint32 column_of(const struct tx_tile *tile, uint32 s)
{
    if (tile->size == TX_8 || tile->format == TX_YUV)
        return s >> 1;
    return tile->size == TX_4 ? s >> 2 : s;
}

/* 8 bytes for a row, at texel s: 16-bit units in order, the long halves of odd rows swapped;
   of RGBA 32 and YUV two units into each half of TMEM. */
static void put_chunk(struct tx *tx, const struct tx_tile *tile, uint32 row, uint32 s,
                      const uint8 *d)
{
    const uint32 base = ((tile->line * row & 511) + tile->tmem) * 4;
    const uint32 odd = (row & 1) * 2;
    uint32 unit = base + column_of(tile, s);

    if (!is_split(tile)) {
        unit &= 0x7fc;
        for (uint32 i = 0; i < 4; i++, d += 2)
            put_unit(tx, (unit + i) ^ odd, d[0], d[1]);
        return;
    }
    unit = ((unit & 0x7fe) ^ odd) & 0x3ff;
    if (tile->format == TX_YUV) {
        put_unit(tx, unit, d[0], d[2]);
        put_unit(tx, unit + 1, d[4], d[6]);
        put_unit(tx, unit + 0x400, d[1], d[3]);
        put_unit(tx, unit + 0x401, d[5], d[7]);
    } else {
        put_unit(tx, unit, d[0], d[1]);
        put_unit(tx, unit + 1, d[4], d[5]);
        put_unit(tx, unit + 0x400, d[2], d[3]);
        put_unit(tx, unit + 0x401, d[6], d[7]);
    }
}

/* Whether bytes of DRAM are there, without a sum that could wrap. */
static int32 inside(const struct tx *tx, uint32 from, uint32 bytes)
{
    return tx->dram && bytes <= tx->dram_bytes && from <= tx->dram_bytes - bytes;
}

/* What both texel loads want of image and tile. */
static enum tx_result check_image(const struct tx *tx, const struct tx_tile *tile)
{
    if (tx->image.size == TX_4)
        return TX_IMAGE_4_BIT;
    if (!tx->checked)
        return TX_DONE;
    if (tx->image.address & 7)
        return TX_IMAGE_MISALIGNED;
    if (tile->size != tx->image.size || !tx_loadable_pair(tx->image.format, tx->image.size)
        || !tx_loadable_pair(tile->format, tile->size))
        return TX_ILLEGAL_PAIR;
    return TX_DONE;
}

/* Whether words of 64 bits, `end` the one behind the last, stay where the tile's texels
   belong. */
static enum tx_result check_room(const struct tx *tx, const struct tx_tile *tile, uint32 end)
{
    if (!tx->checked)
        return TX_DONE;
    if (is_split(tile)) {
        if (tile->tmem >= TX_HALF_WORDS)
            return TX_SPLIT_HIGH;
        return end > TX_HALF_WORDS ? TX_LOAD_TOO_LARGE : TX_DONE;
    }
    if (tile->format == TX_CI && (tile->tmem >= TX_HALF_WORDS || end > TX_HALF_WORDS))
        return TX_INDEX_HIGH;
    return end > TX_TMEM_WORDS ? TX_LOAD_TOO_LARGE : TX_DONE;
}

/* TMEM words that chunks take from the beginning of a row on: split ones take half. */
static uint32 words_of(const struct tx_tile *tile, uint32 chunks)
{
    return is_split(tile) ? (chunks + 1) >> 1 : chunks;
}

enum tx_result tx_load_tile_words(struct tx *tx, uint32 hi, uint32 lo)
{
    const struct tx_tile *tile = &tx->tiles[tx_bits(lo, 26, 24)];
    const uint32 left = tx_bits(hi, 23, 14), top = tx_bits(hi, 11, 2);
    const uint32 right = tx_bits(lo, 23, 14), bottom = tx_bits(lo, 11, 2);
    const uint32 texel_shift = tx->image.size - 1u, step = 16u >> tx->image.size;
    enum tx_result result = check_image(tx, tile);
    uint32 chunks, rows, last_from;

    if (result != TX_DONE)
        return result;
    if (right < left || bottom < top) {
        if (tx->checked)
            return TX_LOAD_BACKWARDS;
        tx_set_edges(tx, hi, lo);
        return TX_DONE;
    }
    rows = bottom - top + 1;
    chunks = (right - left + step) / step;
    result = check_room(tx, tile, tile->tmem + (rows - 1) * tile->line + words_of(tile, chunks));
    if (result != TX_DONE)
        return result;
    last_from = tx->image.address + ((bottom * tx->image.width + left) << texel_shift);
    if (!inside(tx, last_from, 8 * chunks))
        return TX_OUTSIDE_DRAM;
    tx_set_edges(tx, hi, lo);
    for (uint32 row = 0; row < rows; row++) {
        const uint8 *from = tx->dram + tx->image.address
            + (((top + row) * tx->image.width + left) << texel_shift);

        for (uint32 chunk = 0; chunk < chunks; chunk++)
            put_chunk(tx, tile, row, chunk * step, from + 8 * chunk);
    }
    tx->tmem_generation++;
    return TX_DONE;
}

enum tx_result tx_load_block_words(struct tx *tx, uint32 hi, uint32 lo)
{
    const struct tx_tile *tile = &tx->tiles[tx_bits(lo, 26, 24)];
    const uint32 first = tx_bits(hi, 23, 12), last = tx_bits(lo, 23, 12);
    const uint32 top = tx_bits(hi, 11, 0), dxt = tx_bits(lo, 11, 0);
    const uint32 texel_shift = tx->image.size - 1u, step = 16u >> tx->image.size;
    enum tx_result result = check_image(tx, tile);
    uint32 chunks, from;

    if (result != TX_DONE)
        return result;
    if (last < first) {
        if (tx->checked)
            return TX_LOAD_BACKWARDS;
        tx_set_edges(tx, hi, lo);
        return TX_DONE;
    }
    if (tx->checked && last - first >= TX_BLOCK_TEXELS)
        return TX_BLOCK_TOO_LARGE;
    chunks = (last - first + step) / step;
    result = check_room(tx, tile, tile->tmem + ((chunks - 1) * dxt >> 11) * tile->line
                        + words_of(tile, chunks));
    if (result != TX_DONE)
        return result;
    from = tx->image.address + ((top * tx->image.width + first) << texel_shift);
    if (!inside(tx, from, 8 * chunks))
        return TX_OUTSIDE_DRAM;
    tx_set_edges(tx, hi, lo);
    for (uint32 chunk = 0; chunk < chunks; chunk++)
        put_chunk(tx, tile, chunk * dxt >> 11, chunk * step, tx->dram + from + 8 * chunk);
    tx->tmem_generation++;
    return TX_DONE;
}

static enum tx_result check_tlut(const struct tx *tx, const struct tx_tile *tile, uint32 entries)
{
    if (tx->image.size == TX_4)
        return TX_IMAGE_4_BIT;
    if (tx->image.size != TX_16)
        return TX_TLUT_IMAGE;
    if (!tx->checked)
        return TX_DONE;
    if (tx->image.address & 7)
        return TX_IMAGE_MISALIGNED;
    if (tile->size != TX_4)
        return TX_TLUT_TILE;
    if (tile->tmem < TX_HALF_WORDS)
        return TX_TLUT_LOW;
    if (entries > 256 || tile->tmem + entries > TX_TMEM_WORDS)
        return TX_TLUT_ENTRIES;
    return TX_DONE;
}

/* One word of TMEM an entry, which is in it four times. */
enum tx_result tx_load_tlut_words(struct tx *tx, uint32 hi, uint32 lo)
{
    const struct tx_tile *tile = &tx->tiles[tx_bits(lo, 26, 24)];
    const uint32 first = tx_bits(hi, 23, 14), last = tx_bits(lo, 23, 14);
    const uint32 top = tx_bits(hi, 11, 2), entries = last - first + 1;
    enum tx_result result;
    uint32 from;

    if (tx_bits(lo, 11, 2) != top)
        return TX_TLUT_ROWS;
    if (last < first) {
        if (tx->checked)
            return TX_LOAD_BACKWARDS;
        tx_set_edges(tx, hi, lo);
        return TX_DONE;
    }
    result = check_tlut(tx, tile, entries);
    if (result != TX_DONE)
        return result;
    from = tx->image.address + 2 * (top * tx->image.width + first);
    if (!inside(tx, from, 2 * entries))
        return TX_OUTSIDE_DRAM;
    tx_set_edges(tx, hi, lo);
    for (uint32 i = 0; i < entries; i++) {
        const uint8 *entry = tx->dram + from + 2 * i;

        for (uint32 copy = 0; copy < 4; copy++)
            put_unit(tx, ((tile->tmem + i) * 4 + copy) & 0x7ff, entry[0], entry[1]);
    }
    tx->tmem_generation++;
    return TX_DONE;
}
