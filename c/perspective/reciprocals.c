/* Makes the table of reciprocals for spans with perspective. */
#include "span/far.h"

const uint16 *reciprocals_make(uint16 *table)
{
    uint16 *to = table;

    for (uint32 i = FAR_LOWEST; i < FAR_LOWEST + FAR_COUNT; i++)
        *to++ = (uint16)((((uint32)1 << 29) + i) / (2 * i + 1));
    return table + (FAR_ORIGIN - FAR_LOWEST);
}
