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
