/* Draws the instances that are at one place in a scene's order. */
#ifndef SCENE_DRAW_MESHES_H
#define SCENE_DRAW_MESHES_H

#include "scene/scene.h"

/* Draws instances first to end (excluded) of frame `number` together, the farthest faces first;
   returns why a polygon was refused, or POLYGON_DRAWN. */
enum polygon_result mesh_draw(struct renderer *renderer, const struct scene *scene, int32 number,
                              uint32 first, uint32 end);

#endif
