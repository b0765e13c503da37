/* Copy mode: four 16-bit texels at once, as they are. Of other texels without a TLUT, which no
   manual allows, the first long is four bytes of red or intensity. */
#include "tx/texel.h"

/* Shift and origin only: copy mode does not clamp. */
static int32 first_index(const struct tx_axis *axis, int32 c)
{
    return (tx_shifted(axis, c) - 8 * axis->low) >> 5;
}

/* The 16 bits that hold a texel; of 32 bits those in the low half. */
static uint32 unit(const struct tx *tx, const struct tx_tile *tile, int32 s, int32 row)
{
    const uint32 address = tx_texel_address(tile, tile->size, s, row)
        & (tile->size == TX_32 ? 0x7fe : 0xffe);

    return (uint32)tx->tmem[address] << 8 | tx->tmem[address + 1];
}

void tx_copy_texels(const struct tx *tx, int32 n, int32 s, int32 t, uint32 *texels)
{
    const struct tx_tile *tile = &tx->tiles[n & 7];
    const int32 first = first_index(&tile->s, s);
    struct tx_place column, row;
    uint32 reds = 0;

    tx_place_row(&tile->t, (uint32)first_index(&tile->t, t), &row);
    for (int32 i = 0; i < 4; i++) {
        uint32 bits;

        tx_place_column(&tile->s, (uint32)(first + i), &column);
        if (tx->modes.tlut)
            bits = tx_tlut_entry(tx, tx_tlut_index(tx, tile, column.index, row.index), i);
        else
            bits = unit(tx, tile, column.index, row.index);
        texels[i >> 1] = texels[i >> 1] << 16 | bits;
        if (!tx->modes.tlut && tile->size != TX_16) {
            struct tx_colour texel;

            tx_fetch(tx, tile, column.index, row.index, 0, &texel);
            reds = reds << 8 | (uint32)texel.r;
        }
    }
    if (!tx->modes.tlut && tile->size != TX_16)
        texels[0] = reds;
}
