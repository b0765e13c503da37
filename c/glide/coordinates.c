#include "glide/pixel.h"
#include "glide/product.h"

/* Returns 2^32 / w in 23 bits; bit 31 of w must be set. Interpolates linearly between two of the
   entries 2^31 / (512 + i), rounded down, i = 0 to 512. */
static uint32 reciprocal(uint32 w)
{
    const uint32 i = w >> 22 & 511, part = w >> 14 & 255;
    const uint32 from = 0x80000000u / (512 + i), to = 0x80000000u / (513 + i);

    return ((from << 8) - (from - to) * part) >> 8;
}

/* Shifts a magnitude right, or left if shift is negative, gives it its sign and clamps it to 32
   bits. The result is rounded down: a negative number's magnitude is rounded up. */
static int32 cut(struct number64 number, int32 shift, int32 negative)
{
    const struct number64 below = {0, shift > 0 && negative ? (1u << shift) - 1 : 0};
    const uint32 limit = negative ? 0x80000000u : 0x7fffffff;
    uint32 value;

    number = glide_sum(number, below);
    if (shift < 0) {
        number.hi = number.hi << -shift | number.lo >> (32 + shift);
        number.lo <<= -shift;
    } else if (shift > 0) {
        number.lo = number.lo >> shift | number.hi << (32 - shift);
        number.hi >>= shift;
    }
    value = number.hi || number.lo > limit ? limit : number.lo;
    return (int32)(negative ? 0 - value : value);
}

int32 glide_table_quotient(int32 s, int32 w)
{
    uint32 normal = fix_magnitude(w);
    int32 shift = 23;

    if (!w)
        return 0;
    for (; !(normal >> 31); normal <<= 1)
        shift--;
    return cut(glide_product(fix_magnitude(s), reciprocal(normal)), shift, (s < 0) != (w < 0));
}

/* Returns hi * 2^32 + lo divided by w, rounded up if up is 1, else down; hi must be below w. */
static uint32 divided(uint32 hi, uint32 lo, uint32 w, uint32 up)
{
    for (int32 bit = 0; bit < 32; bit++) {
        const uint32 carry = hi >> 31;

        hi = hi << 1 | lo >> 31;
        lo <<= 1;
        if (carry || hi >= w) {
            hi -= w;
            lo |= 1;
        }
    }
    return hi && up && lo != 0xffffffff ? lo + 1 : lo;
}

static int32 exact_quotient(int32 s, int32 w)
{
    const uint32 negative = (s < 0) != (w < 0), limit = negative ? 0x80000000u : 0x7fffffff;
    const uint32 size = fix_magnitude(s), by = fix_magnitude(w);
    uint32 value = limit;

    if (!w)
        return 0;
    if (size >> 2 < by)
        value = divided(size >> 2, size << 30, by, negative);
    if (value > limit)
        value = limit;
    return (int32)(negative ? 0 - value : value);
}

void glide_project(const struct glide *glide, const struct glide_point *point, int32 *s, int32 *t)
{
    if (glide->modes.clamp_negative_w && point->w < 0) {
        *s = *t = 0;
    } else if (glide->modes.perspective && glide->modes.table_quotients) {
        *s = glide_table_quotient(point->s, point->w);
        *t = glide_table_quotient(point->t, point->w);
    } else if (glide->modes.perspective) {
        *s = exact_quotient(point->s, point->w);
        *t = exact_quotient(point->t, point->w);
    } else {
        *s = point->s;
        *t = point->t;
    }
}
