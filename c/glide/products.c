/* The table by which a filter's texels are multiplied. */
#include "glide/passes.h"

/* Four products at a time: two in the words of each sum, whose upper bytes are kept. A word holds
   255 * 256, the greatest. */
void glide_products_make(uint8 *table)
{
    for (uint32 half = 0; half < 2; half++) {
        uint32 *to = (uint32 *)(table + (half ? 0 : GLIDE_PRODUCTS));

        for (uint32 m = 128 * half; m < 128 * half + 128; m++) {
            const uint32 step = (m + 1) * 0x00040004;
            uint32 even = (m + 1) * 2, odd = even + (m + 1) * 0x10001;

            for (uint32 n = 0; n < 64; n++) {
                *to++ = (even & 0xff00ff00) | (odd >> 8 & 0x00ff00ff);
                even += step;
                odd += step;
            }
        }
    }
}
