/* Makes the tables of logarithms and powers for spans with perspective. */
#include "math/math.h"
#include "span/logarithm.h"

#define ONE_2_30 ((uint32)1 << 30)           /* of mantissas, 2.30 */
#define COARSE 1079572136               /* 2^(1/128) */
#define FINE 1073787251                 /* 2^(1/16384) */

enum { FACTORS = 128, FIRST_BIT = 13, OCTAVES = 3 };    /* of the indices */

/* Fills in the powers of a factor. The factor is off by half a unit and each of 127 products by one,
   which allows 2^-22.4 of the power. With these two factors the powers are off by up to 2^-23.8,
   worked out entry by entry. */
static void multiply_up(int32 *to, int32 factor)
{
    *to = (int32)ONE_2_30;
    for (int32 i = 1; i < FACTORS; i++, to++)
        to[1] = mul_shift(*to, factor, 30);
}

/* Returns 2^(t / LOGARITHM_OCTAVE), 2.30. */
static uint32 mantissa(const int32 *coarse, const int32 *fine, int32 t)
{
    return t == LOGARITHM_OCTAVE ? 2 * ONE_2_30
        : (uint32)mul_shift(coarse[t / FACTORS], fine[t % FACTORS], 30);
}

/* Writes a mantissa's power in every octave, to the nearest; `to`: its entry in the highest one. */
static void set_powers(uint16 *to, uint32 here)
{
    here >>= 30 - LOGARITHM_OCTAVES;
    for (int32 left = LOGARITHM_OCTAVES; left; left--) {
        *to = (uint16)((here + 1) >> 1);
        here >>= 1;
        to -= LOGARITHM_OCTAVE;
    }
}

void logarithms_make(struct logarithm_tables *tables, int16 *logs, uint16 *powers)
{
    static int32 coarse[FACTORS], fine[FACTORS];
    int16 *to[OCTAVES];
    uint32 index[OCTAVES], part = ONE_2_30, here = ONE_2_30;  /* index: each octave's next */
    uint32 *parts = tables->parts;

    multiply_up(coarse, COARSE);
    multiply_up(fine, FINE);
    for (int32 k = 0; k < OCTAVES; k++) {
        to[k] = logs + ((1 << (FIRST_BIT + k)) - LOGARITHM_LOWEST);
        index[k] = ONE_2_30 + (ONE_2_30 >> (FIRST_BIT + 1 + k));
    }
    for (int32 t = 0; t <= LOGARITHM_OCTAVE; t++) {
        /* An index has the logarithm t if it is below the middle between t's power and the next. */
        uint32 next = t < LOGARITHM_OCTAVE ? mantissa(coarse, fine, t + 1) : here;
        uint32 middle = t < LOGARITHM_OCTAVE ? (here >> 1) + (next >> 1) : 2 * ONE_2_30;

        for (int32 k = 0; k < OCTAVES; k++)
            for (; index[k] < middle; index[k] += ONE_2_30 >> (FIRST_BIT + k))
                *to[k]++ = (int16)(LOGARITHM_MIDDLE - ((FIRST_BIT + k) << LOGARITHM_BITS) - t);
        for (; part < next; part += ONE_2_30 / LOGARITHM_PARTS)
            *parts++ = ((uint32)t << 8) + ((part - here) << 8) / (next - here);
        if (t < LOGARITHM_OCTAVE)
            set_powers(powers + (LOGARITHM_OCTAVES - 1) * LOGARITHM_OCTAVE + t, here);
        here = next;
    }
    *parts = (uint32)LOGARITHM_OCTAVE << 8;
    logs[LOGARITHM_COUNT - 1] = logs[LOGARITHM_COUNT - 2];
    tables->logs = logs + (LOGARITHM_ORIGIN - LOGARITHM_LOWEST);
    tables->powers = powers;
}
