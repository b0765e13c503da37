#include "glide/passes.h"
#include "glide/pixel.h"

int32 glide_logarithm(uint32 hi, uint32 lo)
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
        if (hi > glide_logarithms[found + step - 1])
            found += step;
    found += hi > glide_logarithms[found];      /* 255 so far at most */
    return exponent * 256 + found;
}
