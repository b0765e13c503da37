#include "scene/load.h"

const char *scene_why(const struct scene *scene, uint32 result)
{
    static const char *const why[] = {
        "", "", "fewer than 3 or more than 64 vertices", "a vertex is out of range",
        "gradients polygon are for triangles", "its mapper cannot draw its map or this frame"
    };

    return result == POLYGON_REFUSED ? scene_why_refused(scene) : why[result];
}
