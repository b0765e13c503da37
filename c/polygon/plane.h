/* A texture plane: how s and t run over the screen. */
#ifndef PLANE_H
#define PLANE_H

#include "polygon/polygon.h"

/* Signed 32.32 fixed point. */
struct wide {
    int32 hi;
    uint32 lo;
};

/* Texels a pixel, modulo 2^32 texels. */
struct plane {
    struct wide dsdx, dsdy, dtdx, dtdy;
};

/* src68k/math: contracts there. */
int32 cross(const struct vertex *e1, const struct vertex *e2, struct wide *size);
int32 gradients(const struct vertex *e1, const struct vertex *e2, struct plane *plane);
fix16 wide_mul(const struct wide *gradient, fix16 offset);
fix16 mul_fix(fix16 a, fix16 b);
int32 mul_div(int32 a, int32 b, int32 c);

#endif
