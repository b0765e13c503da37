/* Triangles of one material that share vertices. */
#ifndef TRIANGLE_LIST_H
#define TRIANGLE_LIST_H

#include "polygon/polygon.h"
#include "triangle/triangles.h"

struct triangle_list {
    const struct vertex *vertices;
    int32 vertex_count;
    const uint16 *indices;              /* of vertices, three for each triangle */
    int32 count;                        /* triangles */
    int32 cull;                         /* 1: leave out those whose corners are anticlockwise on the
                                           screen */
    struct snapped_vertex *room;        /* vertex_count; undefined afterwards */
};

/* Draws the triangles in their order, with the mappers of polygon_draw. Every vertex is converted
   once if the material has EDGES_SNAPPED and a routine for triangles (triangle_tables_make,
   renderer->triangles); a triangle that the routine cannot draw, and those of other materials, are
   drawn by polygon_draw, from the same rounded vertices. Returns POLYGON_DRAWN, or why one of them was
   refused. */
enum polygon_result triangles_draw(struct renderer *renderer, const struct triangle_list *list,
                                   const struct material *material);

#endif
