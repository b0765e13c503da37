#include "polygon/vertex.h"

fix16 vertex_range(const fix16 *value, int32 count, fix16 *least)
{
    fix16 low = *value, high = low;

    for (; count > 1; count--) {
        value += VERTEX_FIELDS;
        if (*value < low)
            low = *value;
        if (*value > high)
            high = *value;
    }
    *least = low;
    return high - low;
}
