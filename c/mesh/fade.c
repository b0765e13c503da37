/* Fog: shades of corners by their depths. */
#include "math/math.h"
#include "mesh/mesh.h"

void mesh_fade(struct vertex *v, int32 count, const struct mesh_fog *fog)
{
    for (; count > 0; count--, v++)
        v->shade = v->w <= fog->near ? fog->bright
                 : v->w >= fog->far ? fog->dark
                 : fog->bright - mul_div(v->w - fog->near, fog->bright - fog->dark, fog->far - fog->near);
}

/* Any plane through three corners is near the others if their shades are within one. */
uint32 mesh_fade_planar(const struct vertex *v, int32 count)
{
    const uint32 in_space = PLANAR_ALL - PLANAR_TEXELS;
    fix16 low = v->shade, high = low;

    if (count == 3)
        return in_space;
    while (--count > 0) {
        v++;
        low = v->shade < low ? v->shade : low;
        high = v->shade > high ? v->shade : high;
    }
    return high - low <= PLANAR_SHADE ? in_space : in_space - PLANAR_SHADES + PLANAR_ROUGH;
}
