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

#define BELOW 22        /* bits below those that the numbers of an entry share */

void glide_logarithms_make(struct glide_logarithm *logarithms, const uint32 *limits)
{
    uint32 passed = 0;

    for (uint32 i = 0; i < GLIDE_LOGARITHMS; i++) {
        const uint32 last = (0x80000000u | i << BELOW) + ((1u << BELOW) - 1);

        logarithms[i].value = (uint16)passed;
        logarithms[i].spare = 0;
        logarithms[i].limit = 0xffffffff;
        if (passed < 256 && limits[passed] <= last)
            logarithms[i].limit = limits[passed++];
    }
}
