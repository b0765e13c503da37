/* Faces of a mesh as batches of triangles with snapped vertices. */
#ifndef MESH_GATHER_H
#define MESH_GATHER_H

#include "mesh/mesh.h"
#include "triangle/triangles.h"

struct snap_plan {
    uint32 right, bottom;       /* largest x and y, 1/16 pixel */
    int32 count;                /* 1 or more */
    const struct mesh_point *points;
    struct mesh_place *to;
};

enum gather_values {
    GATHER_NONE, GATHER_SHADES, GATHER_TEXELS, GATHER_LIT
};

struct gather_plan {
    const struct mesh_face *from;       /* of a list */
    struct snapped_vertex *vertices;
    struct triangle *list;
    struct triangle *last;              /* set to the place behind the last triangle */
    const struct triangle *full;        /* behind this place of the list no face is taken */
    const struct material *material;    /* of all the faces */
    uint32 flags;                       /* of their instances; GATHER_SHADES and GATHER_LIT: with MESH_LIT */
    int32 values;                       /* enum gather_values */
    fix16 scale;                        /* of the map; 0 for 1 */
    const struct mesh_placed *placed;   /* the last face's: mesh_gather sets it, and its corners */
    const struct scene_corner *corners;
};

/* src68k/mesh: contracts there. */
void mesh_snap(const struct snap_plan *plan);
const struct mesh_face *mesh_gather(struct gather_plan *plan);
const struct mesh_face *mesh_link(struct gather_plan *plan);

enum { BATCH_TRIANGLES = 64 };

/* Room for a batch: a face of three corners needs a triangle and three vertices. */
struct mesh_batch {
    struct triangle list[BATCH_TRIANGLES];
    struct snapped_vertex vertices[3 * BATCH_TRIANGLES];
};

#endif
