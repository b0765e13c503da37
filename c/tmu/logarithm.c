#include "tmu/passes.h"
#include "tmu/pixel.h"

int32 tmu_logarithm(uint32 hi, uint32 lo)
{
    int32 exponent = 63, found = 0;

    if (!hi) {
        hi = lo;
        lo = 0;
        exponent = 31;
    }
    for (; !(hi >> 31); exponent--) {
        hi = hi << 1 | lo >> 31;
        lo <<= 1;
    }
    for (int32 step = 128; step; step >>= 1)
        if (hi > tmu_logarithms[found + step - 1])
            found += step;
    found += hi > tmu_logarithms[found];        /* 255 so far at most */
    return exponent * 256 + found;
}
