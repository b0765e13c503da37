/* Triangles collected for one call of their routine. */
#ifndef TRIANGLE_BATCH_H
#define TRIANGLE_BATCH_H

#include "triangle/polygon.h"

enum { BATCH_TRIANGLES = 64 };

struct triangle_batch {
    const struct material *material;    /* of the last triangle_begin; 0 before */
    triangle_drawer *routine;           /* 0: the material has none */
    struct triangle_plan plan;
    struct triangle_range range;
    int32 count;                        /* triangles in the list */
    struct triangle list[BATCH_TRIANGLES];
    struct snapped_vertex vertices[3 * BATCH_TRIANGLES];        /* three a triangle */
};

/* Begins an empty batch of a material; nothing may be left in it. */
void triangle_begin(struct triangle_batch *batch, const struct renderer *renderer,
                    const struct material *material);

/* Returns room for the vertices of the next triangle or quadrilateral, which triangle_add adds. Draws
   the batch first if it is full. */
struct snapped_vertex *triangle_room(struct triangle_batch *batch);

/* Adds a polygon of up to triangle_corners() corners, whose vertices are in the room, as a fan of triangles. */
void triangle_add(struct triangle_batch *batch, int32 corners);

/* Draws what is in the batch and empties it. */
void triangle_flush(struct triangle_batch *batch);

#endif
