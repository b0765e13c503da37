#include "math/math.h"
#include "mesh/mesh.h"

static int32 larger(int32 most, fix16 coordinate)
{
    const int32 size = (int32)fix_magnitude(coordinate);

    return size > most ? size : most;
}

void mesh_points16(struct mesh_point16 *to, const struct scene_point *from, int32 count)
{
    int32 most = 1;

    for (int32 i = 0; i < count; i++)
        most = larger(larger(larger(most, from[i].x), from[i].y), from[i].z);
    for (; count > 0; count--, from++, to++) {
        to->x = (int16)mul_div(from->x, MESH_UNIT16, most);
        to->y = (int16)mul_div(from->y, MESH_UNIT16, most);
        to->z = (int16)mul_div(from->z, MESH_UNIT16, most);
        to->spare = 0;
        to->product = to->x * to->y;
    }
}
