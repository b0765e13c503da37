#include "n64/passes.h"

#define HALF (N64_RECIPROCALS / 2)

/* s * r >> (13 - shift) is the upper half of (s << 16) * (r << (3 + shift)), where shift brings
   w's highest bit to bit 14. For w and 2 w r is the same and the shift differs by one, so only
   the upper half of the table is calculated, in straight lines of 256 entries. The entry of w = 1
   is one less, to be a signed number: only quotients that are clamped differ. */
void n64_divide_table_make(uint32 *reciprocals)
{
    uint32 *to = reciprocals + HALF;

    for (int32 i = 0; i < HALF / 256; i++) {
        const int32 from = n64_inverses[i], step = (n64_inverses[i + 1] - from) * 4;
        int32 below = 0;

        for (int32 k = 0; k < 256; k++, below += step)
            *to++ = (uint32)(from + (below >> 10)) << 3;
    }
    for (int32 w = HALF - 1; w > 1; w--)
        reciprocals[w] = reciprocals[2 * w] << 1;
    reciprocals[0] = reciprocals[1] = 0x7fffffff;
}
