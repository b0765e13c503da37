#include "tx/passes.h"

/* 2^20 / (64 + i), the hardware's: all are the rounded ones but one. */
static int32 inverse(int32 i)
{
    return i == 6 ? 14979 : ((2 << 20) / (64 + i) + 1) >> 1;
}

/* s * r >> (13 - shifts) is the upper half of (s << 16) * (r << (3 + shifts)). Of w = 1 it is
   one less, to be a signed number: the quotients differ where they are clamped alone. */
void tx_divide_table_make(uint32 *reciprocals)
{
    int32 shifts = 14;

    *reciprocals++ = 0x7fffffff;
    for (int32 w = 1; w < 0x8000; w++) {
        int32 n, i, r;

        while ((w << shifts) >= 0x8000)
            shifts--;
        n = w << shifts & 0x3fff;
        i = n >> 8;
        r = inverse(i);
        r += ((inverse(i + 1) - r) * (n & 255) * 4) >> 10;
        *reciprocals++ = w == 1 ? 0x7fffffff : (uint32)r << (3 + shifts);
    }
}
