#include "texture/map.h"

/* Returns log2 of a side, or 0 if the side is not a power of two from MAP_SIDE_MIN to 2^15. */
static uint32 bits_of(int32 side)
{
    uint32 bits = 3;

    while (bits < 15 && MAP_SIDE_MIN << (bits - 3) < side)
        bits++;
    return MAP_SIDE_MIN << (bits - 3) == side ? bits : 0;
}

int32 column_layout_make(struct column_layout *layout, int32 width, int32 height)
{
    uint32 u_bits = bits_of(width), v_bits = bits_of(height);

    if (!u_bits || !v_bits || u_bits + v_bits > MAP_COLUMNS_BITS)
        return 0;
    layout->v_bits = v_bits;
    layout->v_mask = (((uint32)1 << v_bits) - 1) << 2;
    layout->u_mask = (((uint32)1 << (u_bits + v_bits)) - 1) ^ layout->v_mask;
    return 1;
}
