#include "tx/decode.h"

#include "system/system.h"

/* One column of a decoded tile: its texel and the one's beside it in quads, and which decoded
   column that is, or -1. */
struct column {
    int16 index, next, next_at;
};

/* A tile's columns while it is decoded: as many as a mirrored mask of 10 bits has. */
static struct column columns[2048];

/* log2 of how many columns or rows the relative coordinates can tell apart. */
static uint32 bits_of(const struct tx_axis *axis)
{
    const uint32 mask = axis->mask < 10 ? axis->mask : 10;
    const uint32 period = mask + (axis->mirror ? 1 : 0);
    const uint32 last = (uint32)((axis->high >> 2) - (axis->low >> 2)) & 0x3ff;
    uint32 bits = 0;

    if (axis->mask && !axis->clamp)
        return period;
    while (last >> bits)
        bits++;
    return axis->mask && period < bits ? period : bits;
}

/* reach: steps to the texel beside. */
static void list_columns(const struct tx_axis *axis, int32 count, int32 reach)
{
    struct tx_place place;

    for (int32 k = 0; k < count; k++) {
        tx_place_column(axis, (uint32)k, &place);
        columns[k].index = (int16)place.index;
        columns[k].next = (int16)(place.index + reach * place.step);
    }
    for (int32 k = 0; k < count; k++) {
        const int32 beside = (k + reach) & (count - 1);

        columns[k].next_at = (int16)(columns[beside].index == columns[k].next ? beside : -1);
    }
}

/* A row's texels and the next one's. */
static void place_row(const struct tx_tile *tile, int32 j, int32 *index, int32 *next)
{
    struct tx_place row;

    tx_place_row(&tile->t, (uint32)j, &row);
    *index = row.index & 255;
    *next = *index + row.step;
}

static uint32 texel_at(const struct tx *tx, const struct tx_tile *tile, int32 s, int32 row)
{
    struct tx_colour texel;

    tx_fetch(tx, tile, s, row, 0, &texel);
    if (tile->format == TX_YUV) {
        texel.r += 128;
        texel.g += 128;
    }
    return (uint32)texel.r << 24 | (uint32)texel.g << 16 | (uint32)texel.b << 8 | (uint32)texel.a;
}

static void decode_texels(const struct tx *tx, const struct tx_tile *tile, int32 width,
                          int32 height, uint32 *texels)
{
    int32 row, next;

    for (int32 j = 0; j < height; j++) {
        place_row(tile, j, &row, &next);
        for (int32 k = 0; k < width; k++)
            *texels++ = texel_at(tx, tile, columns[k].index, row);
    }
}

/* Where a decoded row's lower neighbour is decoded too, or -1. */
static int32 row_below(const struct tx_tile *tile, int32 j, int32 height, int32 next)
{
    const int32 below = j + 1 < height ? j + 1 : 0;
    int32 row, beyond;

    place_row(tile, below, &row, &beyond);
    return row == next ? below : -1;
}

/* Quads of a row, out of texels that are decoded where they are. */
static void decode_quads(const struct tx *tx, const struct tx_tile *tile, int32 width, int32 j,
                         int32 height, const struct tx_kept *kept)
{
    const uint32 *here = kept->texels + j * width, *below;
    struct tx_quad *quad = kept->quads + j * width;
    int32 row, next, below_at;

    place_row(tile, j, &row, &next);
    below_at = row_below(tile, j, height, next);
    below = below_at < 0 ? 0 : kept->texels + below_at * width;
    for (int32 k = 0; k < width; k++, quad++) {
        const struct column *column = &columns[k];
        const int32 at = column->next_at;

        tx_quad_make(quad, here[k],
                     at < 0 ? texel_at(tx, tile, column->next, row) : here[at],
                     below ? below[k] : texel_at(tx, tile, column->index, next),
                     below && at >= 0 ? below[at] : texel_at(tx, tile, column->next, next));
    }
}

uint32 tx_decoded_texel(const struct tx_decoded *from, uint32 s, uint32 t)
{
    return from->texels[(t & from->mask_t) >> 5 << from->columns_bits | (s & from->mask_s) >> 5];
}

static uint32 axis_key(const struct tx_axis *axis)
{
    const uint32 clamps = axis->clamp || !axis->mask;

    return clamps << 31 | (uint32)axis->mirror << 30 | (uint32)axis->mask << 26
        | (clamps ? (uint32)axis->low << 12 | axis->high : 0);
}

void tx_tile_key_find(struct tx_tile_key *key, const struct tx_tile *tile)
{
    key->tile = (uint32)tile->format << 28 | (uint32)tile->size << 26 | (uint32)tile->palette << 18
        | (uint32)tile->line << 9 | tile->tmem;
    key->s = axis_key(&tile->s);
    key->t = axis_key(&tile->t);
}

static int32 holds(const struct tx *tx, const struct tx_tile_key *key, enum tx_quads quads,
                   const struct tx_kept *kept)
{
    return kept->tx == tx && kept->key.tile == key->tile && kept->key.s == key->s
        && kept->key.t == key->t && kept->tmem_generation == tx->tmem_generation
        && kept->tlut == tx->modes.tlut && kept->tlut_type == tx->modes.tlut_type
        && (quads == TX_QUADS_NONE || kept->kind == quads);
}

/* Memory for so many texels and quads: *kept holds nothing until they are made. */
static int32 make_room(struct tx_kept *kept, uint32 texels, int32 quads)
{
    kept->tx = 0;
    kept->decoded.texels = 0;
    kept->decoded.quads = 0;
    if (kept->texels_room < texels) {
        kept->texels_room = 0;
        if (!mem_alloc(&kept->texels, (int32)(texels * sizeof *kept->texels), MEMORY_ANY))
            return 0;
        kept->texels_room = texels;
    }
    if (quads && kept->quads_room < texels) {
        kept->quads_room = 0;
        if (!mem_alloc(&kept->quads, (int32)(texels * sizeof *kept->quads), MEMORY_ANY))
            return 0;
        kept->quads_room = texels;
    }
    return 1;
}

enum tx_result tx_decode(const struct tx *tx, int32 n, enum tx_quads quads,
                         struct tx_kept *kept, int32 *made)
{
    const struct tx_tile *tile = &tx->tiles[n & 7];
    const uint32 columns_bits = bits_of(&tile->s), rows_bits = bits_of(&tile->t);
    struct tx_decoded *decoded = &kept->decoded;
    struct tx_tile_key key;

    tx_tile_key_find(&key, tile);
    if (made)
        *made = 0;
    if (holds(tx, &key, quads, kept))
        return TX_DONE;
    if (columns_bits + rows_bits > TX_DECODE_BITS)
        return TX_DECODE_TOO_LARGE;
    if (!make_room(kept, 1u << (columns_bits + rows_bits), quads != TX_QUADS_NONE))
        return TX_NO_MEMORY;
    list_columns(&tile->s, 1 << columns_bits, quads == TX_QUADS_CHROMA ? 2 : 1);
    decode_texels(tx, tile, 1 << columns_bits, 1 << rows_bits, kept->texels);
    if (quads != TX_QUADS_NONE)
        for (int32 j = 0; j < 1 << rows_bits; j++)
            decode_quads(tx, tile, 1 << columns_bits, j, 1 << rows_bits, kept);
    decoded->texels = kept->texels;
    decoded->quads = quads != TX_QUADS_NONE ? kept->quads : 0;
    decoded->columns_bits = (uint16)columns_bits;
    decoded->rows_bits = (uint16)rows_bits;
    decoded->mask_s = (uint16)(((1u << columns_bits) - 1) << 5);
    decoded->mask_t = (uint16)(((1u << rows_bits) - 1) << 5);
    kept->tx = tx;
    kept->key = key;
    kept->kind = (uint8)quads;
    kept->tmem_generation = tx->tmem_generation;
    kept->tlut = tx->modes.tlut;
    kept->tlut_type = tx->modes.tlut_type;
    if (made)
        *made = 1;
    return TX_DONE;
}
