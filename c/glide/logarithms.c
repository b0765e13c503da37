#include "glide/passes.h"

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
