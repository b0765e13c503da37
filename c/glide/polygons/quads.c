#include "glide/passes.h"

/* Each loop is in one function, calls nothing and fits the instruction cache, so its cycles do not
   depend on where the linker puts other functions. */

#define FIELD 0x00ff00ffu

/* Makes a pair from two channels of the four texels, in the lower bytes of words. */
static void pair_make(struct glide_pair *pair, uint32 c00, uint32 c10, uint32 c01, uint32 c11)
{
    c00 &= FIELD;
    c10 &= FIELD;
    c01 &= FIELD;
    c11 &= FIELD;
    pair->st = c00 - c10 - c01 + c11;
    pair->s = 16 * (c10 - c00);
    pair->t = 16 * (c01 - c00);
    pair->corner = 256 * c00;
}

void glide_quads_make(struct glide_quad *quad, const uint32 *upper, const uint32 *lower, uint32 columns)
{
    uint32 c00 = *upper, c01 = *lower;

    for (uint32 i = 1; i <= columns; i++, quad++) {
        const uint32 next = i < columns ? i : 0, c10 = upper[next], c11 = lower[next];

        pair_make(&quad->rb, c00 >> 8, c10 >> 8, c01 >> 8, c11 >> 8);
        pair_make(&quad->ga, c00, c10, c01, c11);
        c00 = c10;
        c01 = c11;
    }
}

static void pair_8_make(struct glide_pair_8 *pair, uint32 c00, uint32 c10, uint32 c01, uint32 c11)
{
    pair->upper_s = (c10 & FIELD) - (c00 & FIELD);
    pair->upper = (c00 & FIELD) << 8;
    pair->lower_s = (c11 & FIELD) - (c01 & FIELD);
    pair->lower = (c01 & FIELD) << 8;
}

void glide_quads_8_make(struct glide_quad_8 *quad, const uint32 *upper, const uint32 *lower,
                        uint32 columns)
{
    uint32 c00 = *upper, c01 = *lower;

    for (uint32 i = 1; i <= columns; i++, quad++) {
        const uint32 next = i < columns ? i : 0, c10 = upper[next], c11 = lower[next];

        pair_8_make(&quad->rb, c00 >> 8, c10 >> 8, c01 >> 8, c11 >> 8);
        pair_8_make(&quad->ga, c00, c10, c01, c11);
        c00 = c10;
        c01 = c11;
    }
}
