/* Draws the instances that are at one place in a scene's order. */
#ifndef FRAMES_DRAW_MESHES_H
#define FRAMES_DRAW_MESHES_H

#include "scene/scene.h"

/* Draws instances first to end (excluded) of frame `number`: those that follow each other in one tree
   by it, those in none the farthest faces first; then those with TREE_Z, pixel by pixel before and behind
   all of these; returns why a polygon was refused, or
   POLYGON_DRAWN. */
enum polygon_result mesh_draw(struct renderer *renderer, const struct scene *scene, int32 number,
                              uint32 first, uint32 end);

/* Draws the faces of a list, whose instances are placed; returns the same. */
enum polygon_result mesh_draw_faces(struct renderer *renderer, const struct scene *scene,
                                    const struct mesh_face *face);

/* Sets *polygon to a face on the screen, in scratch memory until the next call; returns 0 if nothing is left. */
int32 mesh_face_polygon(struct polygon *polygon, const struct scene *scene, const struct mesh_face *face);

/* Draws it with a material. */
enum polygon_result mesh_draw_polygon(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material);

/* draw_depths.c. Makes the z buffer empty where faces of a list are. */
void mesh_depths_begin(const struct scene *scene, const struct mesh_face *face);

/* Puts faces of a list that have been drawn in this order into it. is_ordered: they are those of a tree, and nothing was
   put into it before. marks: 0, or only faces are put into it that have one of these. */
void mesh_depths_fill(struct renderer *renderer, const struct scene *scene, const struct mesh_face *face,
                      int32 is_ordered, uint32 marks);

/* Draws the faces of a list where they are nearer, as mesh_draw_faces. */
enum polygon_result mesh_depths_draw(struct renderer *renderer, const struct scene *scene,
                                     const struct mesh_face *face);

/* Draws a face, its polygons with `draw`. */
enum polygon_result mesh_draw_face(struct renderer *renderer, const struct scene *scene,
                                   const struct mesh_face *face, polygon_routine *draw);

/* Draws the faces of a list, each pixel once, from the last to the first: the same picture as mesh_draw_faces. */
enum polygon_result mesh_draw_once(struct renderer *renderer, const struct scene *scene,
                                   struct mesh_face *face);

/* draw_near.c. How the instances of a tree were drawn. */
enum near_result {
    NEAR_DRAWN,
    NEAR_OTHERWISE,             /* not at all: they cannot be drawn so */
    NEAR_OVERFLOW               /* in part: all faces are to be drawn back to front */
};

/* Draws the instances of a tree from `first` on, those before `end`, from the nearest face on until the frame is full;
   sets *refused to why a polygon was refused if one was, and *seen to a list of the faces that are seen, back to
   front, in memory of the room. */
enum near_result mesh_draw_near(struct renderer *renderer, const struct scene *scene, int32 number,
                                uint32 first, uint32 end, const struct mesh_work *room,
                                enum polygon_result *refused, struct mesh_face **seen);

/* Sets s and t of an environment's normals; there is at least one. */
void mesh_make_texels(struct mesh_attributes *to, const struct scene_normal *normals, int32 count,
                      const struct scene_view *view);

/* Sets s, t and shade of an instance's normals; there is at least one. */
void mesh_make_attributes(struct mesh_attributes *to, const struct scene_normal *normals,
                          int32 count, const struct scene_instance *instance,
                          const struct scene_view *view);

/* Transforms points of an instance with 32-bit operands, from the first given on. */
void mesh_place_wide(const struct scene *scene, const struct mesh_placed *placed, uint32 first,
                     int32 count);

/* Sets the depths and shades of an instance's fog. */
void mesh_set_fog(struct mesh_fog *to, const struct scene_instance *instance);

#endif
