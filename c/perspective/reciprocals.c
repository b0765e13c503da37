/* Makes the tables of reciprocals for spans with perspective. */
#include "span/far.h"

const uint16 *reciprocals_make(uint16 *table)
{
    uint16 *to = table;

    for (uint32 i = RECIPROCAL_LOWEST; i < 65536; i++)
        *to++ = (uint16)((((uint32)1 << 30) + i) / (2 * i + 1));
    for (uint32 i = FAR_LOWEST; i < FAR_LOWEST + FAR_COUNT; i++)
        *to++ = (uint16)((((uint32)1 << 29) + i) / (2 * i + 1));
    return table + RECIPROCAL_COUNT / 2;
}
