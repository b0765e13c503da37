/* Copy mode: four 16-bit texels at once, as they are. */
#include "tx/texel.h"

/* Shift and origin only: copy mode does not clamp. */
static int32 first_index(const struct tx_axis *axis, int32 c)
{
    if (axis->shift <= 10)
        c = (int16)c >> axis->shift;
    else
        c = (int16)((uint32)c << (16 - axis->shift));
    return (c - 8 * axis->low) >> 5;
}

static uint32 copied(const struct tx *tx, const struct tx_tile *tile, int32 s, int32 row,
                     int32 tap)
{
    uint32 address;

    if (tx->modes.tlut)
        return tx_tlut_entry(tx, tx_tlut_index(tx, tile, s, row), tap);
    address = tx_texel_address(tile, tile->size, s, row) & 0xffe;
    return (uint32)tx->tmem[address] << 8 | tx->tmem[address + 1];
}

void tx_copy(const struct tx *tx, int32 n, int32 s, int32 t, uint32 *texels)
{
    const struct tx_tile *tile = &tx->tiles[n & 7];
    const int32 first = first_index(&tile->s, s);
    struct tx_place column, row;

    tx_place_row(&tile->t, (uint32)first_index(&tile->t, t), &row);
    for (int32 i = 0; i < 4; i++) {
        tx_place_column(&tile->s, (uint32)(first + i), &column);
        texels[i >> 1] = texels[i >> 1] << 16 | copied(tx, tile, column.index, row.index, i);
    }
}
