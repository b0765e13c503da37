/* Products and quotients through 64 bits. src68k/math: contracts there. */
#ifndef MATH_H
#define MATH_H

#include "compiler.h"

/* A number of 64 bits. */
struct number64 {
    uint32 hi, lo;
};

/* |value| */
static inline uint32 fix_magnitude(int32 value)
{
    return value < 0 ? 0 - (uint32)value : (uint32)value;
}

fix16 mul_fix(fix16 a, fix16 b);
fix16 mul_round(fix16 a, fix16 b);
int32 mul_div(int32 a, int32 b, int32 c);
int32 mul_shift(int32 a, int32 b, int32 bits);
int32 mul_wide(const struct number64 *gradient, fix16 offset);

#endif
