/* A tile's coordinate pipeline, one axis at a time. */
#include "n64/texel.h"

uint32 n64_relative(const struct n64_axis *axis, int32 c)
{
    const int32 high = axis->high;
    int32 over;

    c = n64_shifted(axis, c);
    over = c >> 3 >= high;      /* before the origin is taken away */
    c -= 8 * axis->low;
    if (axis->clamp || !axis->mask) {
        if (over)
            return (uint32)(((high >> 2) - (axis->low >> 2)) & 0x3ff) << 5;
        if (c < 0)
            return 0;
    }
    return (uint32)c & 0xffff;
}

void n64_place(const struct n64_axis *axis, uint32 index, uint32 wrapped, struct n64_place *place)
{
    const uint32 mask = axis->mask < 10 ? axis->mask : 10, full = (1u << mask) - 1;

    place->step = 1;
    if (axis->mask) {
        const uint32 inverse = axis->mirror && index >> mask & 1;

        if (inverse)
            index = ~index;
        index &= full;
        if (!axis->mirror) {
            if (index == full)
                place->step = -(int32)(index & wrapped);
        } else if (inverse) {
            place->step = index ? -1 : 0;
        } else if (index == full) {
            place->step = 0;
        }
    }
    place->index = (int32)index;
}
