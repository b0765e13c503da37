#ifndef TMU_WIDE_H
#define TMU_WIDE_H

#include "polygon/math.h"

/* a * b. */
static inline struct number64 tmu_product(uint32 a, uint32 b)
{
    const uint32 low = (a & 0xffff) * (b & 0xffff);
    const uint32 middle = (a >> 16) * (b & 0xffff) + (low >> 16);
    const uint32 other = (a & 0xffff) * (b >> 16) + (middle & 0xffff);
    struct number64 product;

    product.hi = (a >> 16) * (b >> 16) + (middle >> 16) + (other >> 16);
    product.lo = other << 16 | (low & 0xffff);
    return product;
}

/* a + b, modulo 2^64. */
static inline struct number64 tmu_sum(struct number64 a, struct number64 b)
{
    a.lo += b.lo;
    a.hi += b.hi + (a.lo < b.lo);
    return a;
}

static inline uint32 tmu_magnitude(int32 value)
{
    return value < 0 ? 0 - (uint32)value : (uint32)value;
}

#endif
