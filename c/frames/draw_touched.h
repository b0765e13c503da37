/* What a frame's objects touch, by the boxes around their vertices. */
#ifndef FRAMES_DRAW_TOUCHED_H
#define FRAMES_DRAW_TOUCHED_H

#include "coverage/touched.h"
#include "mesh/mesh.h"

/* Adds a polygon's box; count: 1 or more. */
void touched_vertices(struct touched *touched, const struct vertex *vertices, int32 count);

/* Adds the box around the points of an instance that have a mark and are inside all borders. Faces with others are
   clipped, and added one by one. */
void touched_instance(struct touched *touched, const struct mesh_placed *placed, const uint8 *marks);

#endif
