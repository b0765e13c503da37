/* Products and sums of 64 bits. */
#ifndef GLIDE_PRODUCT_H
#define GLIDE_PRODUCT_H

#include "math/math.h"

static inline struct number64 glide_product(uint32 a, uint32 b)
{
    const uint32 low = (a & 0xffff) * (b & 0xffff);
    const uint32 middle = (a >> 16) * (b & 0xffff) + (low >> 16);
    const uint32 other = (a & 0xffff) * (b >> 16) + (middle & 0xffff);
    struct number64 product;

    product.hi = (a >> 16) * (b >> 16) + (middle >> 16) + (other >> 16);
    product.lo = other << 16 | (low & 0xffff);
    return product;
}

/* Returns a + b modulo 2^64. */
static inline struct number64 glide_sum(struct number64 a, struct number64 b)
{
    a.lo += b.lo;
    a.hi += b.hi + (a.lo < b.lo);
    return a;
}

#endif
