/* All instances of one place in a scene's order. */
#ifndef SCENE_DRAW_MESHES_H
#define SCENE_DRAW_MESHES_H

#include "scene/scene.h"

/* What a frame is drawn with. */
struct mesh_target {
    const struct frame *frame;
    int32 number;               /* of the frame in the scene */
    const struct drawing *drawing;      /* faces are planes in space: on the screen texels without
                                           perspective need not lie on any */
};

/* Draws instances first to end (excluded) together, faces far away first; returns why a
   polygon was refused, or POLYGON_DRAWN. */
enum polygon_result mesh_draw(const struct scene *scene, uint32 first, uint32 end,
                              const struct mesh_target *target);

#endif
