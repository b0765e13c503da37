/* Products and quotients through 64 bits. src68k/math: contracts there. */
#ifndef MATH_H
#define MATH_H

#include "compiler.h"

fix16 mul_fix(fix16 a, fix16 b);
int32 mul_div(int32 a, int32 b, int32 c);

#endif
