/* A checked scene in memory, with its textures in the spans' layouts. */
#ifndef SCENE_H
#define SCENE_H

#include "coverage/coverage.h"
#include "depths/depths.h"
#include "glide/polygons/unit.h"
#include "mesh/gather.h"
#include "mesh/bodies.h"
#include "mesh/near.h"
#include "n64/polygons/unit.h"
#include "polygon/polygon.h"
#include "scene/scene_file.h"

/* Of objects that are drawn together, the most and the room for their vertices. */
enum { RUN_POLYGONS = 42, RUN_VERTICES = 128 };

/* Memory for the vertices of a run of objects, or of one face. */
struct scene_scratch {
    struct polygon run[RUN_POLYGONS];
    struct vertex placed[RUN_VERTICES];
    struct vertex face[MESH_CORNERS_MAX], cut[2 * POLYGON_VERTICES_MAX];
    struct mesh_face *buckets[MESH_SORT_BUCKETS];
    struct mesh_batch batch;
};

/* Of trees that are drawn each pixel once. */
struct scene_near {
    struct mesh_box *boxes;     /* one a node */
    struct near_slot *slots;    /* of all trees */
    struct scene_corner *corners;       /* copies of those of trees' instances, one after the other */
    struct scene_point *points; /* those of each tree, each place once */
    struct scene_bodies *bodies;        /* 0 if no instance has TREE_Z */
    uint32 stamp;               /* of the tree that was drawn last */
    int32 is_still;             /* 1: all instances of a tree are in the same frames, with the same views */
};

struct scene {
    const struct scene_header *header;
#define TABLE(name, type) const struct type *name;
#define BLOCK(name)
    TABLE_LIST(TABLE, BLOCK)
#undef TABLE
#undef BLOCK
    struct mesh_work work;
    struct depths *depths;      /* 0 if no instance has TREE_Z */
    struct mesh_point16 *points16;      /* one a point, if there are views16; of meshes that share points
                                   the last one's */
    uint8 *smooth;              /* one a mesh, 1: all corners have the normal of their point's number */
    struct scene_scratch *scratch;
    struct map *maps;           /* one a texture */
    struct scene_near *near;    /* of a scene with `once` that has trees, else 0 */
    struct coverage *coverage;  /* of a scene with `once` and instances, else 0 */
    struct touched *touched;    /* coverage/touched.h: what is drawn is added to it; 0: it is not asked for */
    struct material *drawn;     /* one a material, with its map */
    const uint16 *reciprocals;  /* if a material needs them, else 0 */
    const struct triangle_tables *triangles;    /* the same */
    uint8 tried_reciprocals, tried_triangles;   /* 1: not made again where memory
                                   was short */
    uint8 is_once;              /* 1: instances are drawn with the coverage */
    uint8 is_coarse;            /* 1: frames are those of scene/coarse.h */
    struct n64_unit *engines;   /* one a unit */
    uint32 *n64_reciprocals;    /* of all units; null until a polygon needs them */
    struct glide *glide;        /* one each of glide_units */
    struct glide_pipe *pipe;    /* one each of pipes */
    struct glide_tile_store *tiles;     /* of all pipes */
};

#endif
