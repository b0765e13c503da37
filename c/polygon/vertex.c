#include "polygon/vertex.h"

void vertex_range(const fix16 *value, int32 count, fix16 *low, fix16 *high)
{
    fix16 least = *value, most = *value;

    for (; count > 1; count--) {
        value += VERTEX_FIELDS;
        if (*value < least)
            least = *value;
        if (*value > most)
            most = *value;
    }
    *low = least;
    *high = most;
}
