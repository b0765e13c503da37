#include "triangle/polygon.h"

void triangle_tables_make(struct triangle_tables *tables)
{
    int32 *const table = tables->reciprocals;
    const uint32 one = 0x80000000;

    tables->draw = triangle_polygon;
    tables->run = triangle_run;
    table[0] = 0;
    for (uint32 dy = 1; dy < SNAPPED_RECIPROCALS; dy++) {
        uint32 half = dy >> 1;

        uint32 found = dy < FINER_HEIGHT ? (one + half) / dy
                       : (one / dy << 8) + ((one % dy << 8) + half) / dy;

        table[dy] = (int32)(found < one ? found : one - 1);
    }
}
