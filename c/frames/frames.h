/* Frames of a loaded scene: drawn, timed, counted, saved. */
#ifndef FRAMES_H
#define FRAMES_H

#include "coverage/touched.h"
#include "scene/scene.h"

/* Draws the background and one frame, with the scene's tables; returns why a polygon was refused,
   or POLYGON_DRAWN. */
enum polygon_result scene_draw(struct renderer *renderer, struct scene *scene, int32 number);

/* The same over another frame of the scene, of which `touched` says what is not the background: only that is cleared.
   Sets it to what is not in this frame. */
enum polygon_result scene_draw_over(struct renderer *renderer, struct scene *scene, int32 number,
                                    struct touched *touched);

/* Draws a frame between quiet_enter and quiet_leave; sets *ticks to the time it took. Without ticks
   it does not wait for the beam first, which takes longer than a frame of few polygons. */
enum polygon_result scene_time(struct renderer *renderer, struct scene *scene, int32 number,
                               uint32 *ticks);

/* Adds the polygons, rules and pixels of the frame that was drawn last to counts, one a
   material. */
void scene_count(struct renderer *renderer, struct scene *scene, int32 number,
                 struct draw_counts *counts);

/* Writes a frame as frame_000.chunky and so on; prints a line and returns 0 if it cannot. */
int32 scene_save(const struct frame *frame, int32 number);

#endif
