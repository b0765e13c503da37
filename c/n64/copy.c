/* Copy mode: four 16-bit texels at once, unconverted. If texels of other sizes are read without a
   TLUT, which no manual allows, the first long is four bytes of red or intensity. */
#include "n64/texel.h"

/* Only shifts and subtracts the origin: copy mode does not clamp. */
static int32 first_index(const struct n64_axis *axis, int32 c)
{
    return (n64_shifted(axis, c) - 8 * axis->low) >> 5;
}

/* Returns the 16 bits that hold a texel; of a 32-bit texel those in TMEM's low half. */
static uint32 unit(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row)
{
    const uint32 address = n64_texel_address(tile, tile->size, s, row)
        & (tile->size == N64_32 ? 0x7fe : 0xffe);

    return (uint32)n64->tmem[address] << 8 | n64->tmem[address + 1];
}

void n64_copy_texels(const struct n64 *n64, int32 n, int32 s, int32 t, uint32 *texels)
{
    const struct n64_tile *tile = &n64->tiles[n & 7];
    const int32 first = first_index(&tile->s, s);
    struct n64_place column, row;
    uint32 reds = 0;

    n64_place(&tile->t, (uint32)first_index(&tile->t, t), N64_ROW, &row);
    for (int32 i = 0; i < 4; i++) {
        uint32 bits;

        n64_place(&tile->s, (uint32)(first + i), N64_COLUMN, &column);
        if (n64->modes.tlut)
            bits = n64_tlut_entry(n64, n64_tlut_index(n64, tile, column.index, row.index), i);
        else
            bits = unit(n64, tile, column.index, row.index);
        texels[i >> 1] = texels[i >> 1] << 16 | bits;
        if (!n64->modes.tlut && tile->size != N64_16) {
            struct n64_colour texel;

            n64_fetch(n64, tile, column.index, row.index, 0, &texel);
            reds = reds << 8 | (uint32)texel.r;
        }
    }
    if (!n64->modes.tlut && tile->size != N64_16)
        texels[0] = reds;
}
