/* Draws the instances that are at one place in a scene's order. */
#ifndef FRAMES_DRAW_MESHES_H
#define FRAMES_DRAW_MESHES_H

#include "scene/scene.h"

/* Draws instances first to end (excluded) of frame `number`: those that follow each other in one tree
   by it, those in none the farthest faces first; returns why a polygon was refused, or
   POLYGON_DRAWN. */
enum polygon_result mesh_draw(struct renderer *renderer, const struct scene *scene, int32 number,
                              uint32 first, uint32 end);

/* Draws the faces of a list, whose instances are placed; returns the same. */
enum polygon_result mesh_draw_faces(struct renderer *renderer, const struct scene *scene,
                                    const struct mesh_face *face);

/* Draws a face: with renderer->cover what of it is visible. */
enum polygon_result mesh_draw_face(struct renderer *renderer, const struct scene *scene,
                                   const struct mesh_face *face);

/* Draws the faces of a list, each pixel once, from the last to the first: the same picture as mesh_draw_faces. It
   reverses the list. */
enum polygon_result mesh_draw_once(struct renderer *renderer, const struct scene *scene,
                                   struct mesh_face *face);

/* Transforms points of an instance with 32-bit operands, from the first given on. */
void mesh_place_wide(const struct scene *scene, const struct mesh_placed *placed, uint32 first,
                     int32 count);

#endif
