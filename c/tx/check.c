/* What a state is fit for, and what drawing leaves pending. */
#include "tx/tx.h"

void tx_init(struct tx *tx, const uint8 *dram, uint32 dram_bytes)
{
    const struct tx_input texel = {15, 15, 31, 1}, alpha = {7, 7, 7, 1};
    uint8 *bytes = (uint8 *)tx;

    for (uint32 i = 0; i < sizeof *tx; i++)
        bytes[i] = 0;
    tx->dram = dram;
    tx->dram_bytes = dram_bytes;
    tx->checked = 1;
    for (int32 cycle = 0; cycle < 2; cycle++) {
        tx->combine.rgb[cycle] = texel;
        tx->combine.alpha[cycle] = alpha;
    }
    tx_command(tx, (uint32)TX_OP_OTHER_MODES << 24 | 1u << 11 | 1u << 10, 0);
}

static int32 drawable_pair(uint32 format, uint32 size)
{
    switch (format) {
    case TX_RGBA:
        return size == TX_16 || size == TX_32;
    case TX_YUV:
        return size == TX_16;
    case TX_IA:
        return size != TX_32;
    case TX_CI:
    case TX_I:
        return size == TX_4 || size == TX_8;
    default:
        return 0;
    }
}

int32 tx_loadable_pair(uint32 format, uint32 size)
{
    return size != TX_4 && (drawable_pair(format, size) || (size == TX_16 && format <= TX_I));
}

static int32 is_split(const struct tx_tile *tile)
{
    return tile->format == TX_YUV || (tile->format == TX_RGBA && tile->size == TX_32);
}

static int32 clamps(const struct tx_axis *axis)
{
    return axis->clamp || !axis->mask;
}

/* How many columns or rows an axis can show. */
static uint32 shown(const struct tx_axis *axis)
{
    const uint32 inside = ((uint32)axis->high >> 2) - ((uint32)axis->low >> 2) + 1;
    const uint32 masked = 1u << (axis->mask < 10 ? axis->mask : 10);

    if (!axis->mask)
        return inside;
    return clamps(axis) && inside < masked ? inside : masked;
}

/* TMEM words of a row of so many texels; of split ones, in the low half. */
static uint32 row_words(const struct tx_tile *tile, uint32 texels)
{
    if (tile->size == TX_4)
        return (texels + 15) >> 4;
    if (tile->size == TX_8 || tile->format == TX_YUV)
        return (texels + 7) >> 3;
    return (texels + 3) >> 2;
}

/* Where the texels that a tile can show lie. */
static enum tx_result check_place(const struct tx_tile *tile, int32 low_only)
{
    const uint32 columns = shown(&tile->s), rows = shown(&tile->t);
    const uint32 end = tile->tmem + (rows - 1) * tile->line + row_words(tile, columns);

    if (columns > TX_COLUMNS_MAX || rows > TX_ROWS_MAX)
        return TX_TILE_TOO_LARGE;
    if (is_split(tile)) {
        if (tile->tmem >= TX_HALF_WORDS)
            return TX_SPLIT_HIGH;
        return end > TX_HALF_WORDS ? TX_TILE_OUTSIDE : TX_DONE;
    }
    if (low_only && end > TX_HALF_WORDS)
        return TX_INDEX_HIGH;
    return end > TX_TMEM_WORDS ? TX_TILE_OUTSIDE : TX_DONE;
}

enum tx_result tx_check_tile(const struct tx *tx, int32 n)
{
    const struct tx_tile *tile = &tx->tiles[n & 7];
    const int32 index = tile->format == TX_CI;

    if (!tx->checked)
        return TX_DONE;
    if (!drawable_pair(tile->format, tile->size))
        return TX_ILLEGAL_PAIR;
    if (index != tx->modes.tlut)
        return TX_TLUT_MODE;
    if (tx->modes.cycle == TX_COPY && !index && (tile->size != TX_16 || tile->format == TX_YUV))
        return TX_CYCLE_TYPE;
    if ((clamps(&tile->s) && tile->s.high >> 2 < tile->s.low >> 2)
        || (clamps(&tile->t) && tile->t.high >> 2 < tile->t.low >> 2))
        return TX_TILE_EDGES;
    return check_place(tile, index);
}

uint32 tx_tiles_used(const struct tx *tx)
{
    uint32 count = 1, used = 0;

    if (tx->modes.cycle == TX_FILL)
        return 0;
    if (tx->modes.cycle != TX_COPY && tx->modes.lod)
        count = tx->max_level + 1u + tx->modes.detail;
    else if (tx->inputs & TX_INPUT_TEXEL1)
        count = 2;
    while (count--)
        used |= 1u << ((tx->primitive_tile + count) & 7);
    return used;
}

enum tx_result tx_check_drawing(const struct tx *tx)
{
    const uint32 used = tx_tiles_used(tx);
    enum tx_result result = TX_DONE;

    if (!tx->checked)
        return TX_DONE;
    if (tx->modes.cycle == TX_FILL)
        return TX_CYCLE_TYPE;
    for (int32 n = 0; n < TX_TILES && result == TX_DONE; n++)
        if (used >> n & 1)
            result = tx_check_tile(tx, n);
    return result == TX_DONE ? tx_check_combine(&tx->combine) : result;
}

static int32 in_range(fix16 texels)
{
    return texels >= -(1024 * 65536) && texels < 1024 * 65536;
}

enum tx_result tx_check_coordinates(const struct tx *tx, fix16 s, fix16 t)
{
    return tx->checked && !(in_range(s) && in_range(t)) ? TX_COORDINATE_RANGE : TX_DONE;
}

void tx_drawn(struct tx *tx)
{
    tx->pending = TX_PENDING_LOAD | TX_PENDING_TILE | TX_PENDING_PIPE;
    tx->pending_tiles |= (uint8)tx_tiles_used(tx);
}
