#include "triangle/polygon.h"

void triangle_reciprocals_make(int32 *table)
{
    const uint32 one = 0x80000000;

    table[0] = 0;
    for (uint32 dy = 1; dy < SNAPPED_RECIPROCALS; dy++) {
        uint32 half = dy >> 1;

        uint32 found = dy < FINER_HEIGHT ? (one + half) / dy
                       : (one / dy << 8) + ((one % dy << 8) + half) / dy;

        table[dy] = (int32)(found < one ? found : one - 1);
    }
}

void triangle_tables_make(struct triangle_tables *tables)
{
    tables->draw = triangle_polygon;
    tables->run = triangle_run;
    triangle_reciprocals_make(tables->reciprocals);
}
