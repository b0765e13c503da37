/* Meshes from their points to polygons on the screen. */
#ifndef MESH_H
#define MESH_H

#include "mesh/records.h"
#include "polygon/polygon.h"

/* Borders of what is projected: the near plane and |x|, |y| <= z, the guard band. */
enum mesh_outside {
    MESH_NEAR = 1,              /* z below the near plane */
    MESH_LEFT = 2,              /* x + z below 0 */
    MESH_RIGHT = 4,             /* z - x below 0 */
    MESH_ABOVE = 8,             /* y + z below 0 */
    MESH_BELOW = 16             /* z - y below 0 */
};

/* A point before the camera, and on the screen if it is outside of nothing. */
struct mesh_point {
    fix16 x, y, w;              /* w: z, the depth */
    fix16 screen_x, screen_y;   /* written where outside is 0 */
    uint32 outside;             /* enum mesh_outside, ored */
    uint32 spare[2];            /* 32 bytes: an index is a shift */
};

/* What a normal makes: of an environment s and t, of a light shade. */
struct mesh_look {
    fix16 s, t, shade;
};

struct transform_plan {
    const struct scene_point *from;
    int32 count;                /* one at least */
    const struct scene_view *view;
    struct mesh_point *to;
    fix16 near_plane;
    uint32 guard;               /* as in the scene's header */
    fix16 middle_x, middle_y;   /* of the frame */
};

/* Sums of products: base + (x n.x + y n.y + z n.z) / 32, from low to high. */
struct look_plan {
    const struct scene_normal *from;
    int32 count;                /* one at least */
    fix16 *to;                  /* a field of a mesh_look, and of those that follow */
    const int16 *factors;       /* x, y, z: 9.7 */
    fix16 base, low, high;
};

/* An instance in a frame. */
struct mesh_placed {
    const struct scene_mesh *mesh;
    const struct scene_corner *corners;         /* the mesh's first */
    const struct material *material;
    const struct mesh_point *points;
    const struct mesh_look *looks;
    uint32 flags;
};

/* A face to be drawn. */
struct mesh_face {
    uint32 order;               /* its greatest depth, all bits inverted: small ones first */
    const struct scene_face *face;
    const struct mesh_placed *placed;
};

struct faces_plan {
    const struct scene_face *from;
    int32 count;                /* one at least */
    const struct mesh_placed *placed;
    const struct scene_view *view;
    struct mesh_face *to;
};

/* One border's point of an edge. */
struct cut_plan {
    struct vertex *to;
    const struct vertex *inside, *outside;
    int32 part;                 /* the inner end's way to the border, 0 or more */
    uint32 whole;               /* both ends' way, more than part */
};

/* Memory for the meshes that are drawn together. */
struct mesh_work {
    struct mesh_placed *placed;
    struct mesh_point *points;
    struct mesh_look *looks;
    struct mesh_face *faces, *sorted;
};

/* src68k/mesh: contracts there. */
void mesh_transform(const struct transform_plan *plan);
void mesh_looks(const struct look_plan *plan);
int32 mesh_faces(const struct faces_plan *plan);
void mesh_cut(const struct cut_plan *plan);

enum { MESH_SORT_DIGITS = 256 };

/* Sorts by order, those of the same order as they came; the result is in one of the two
   arrays, which is returned. digits: scratch memory, MESH_SORT_DIGITS. */
struct mesh_face *mesh_sort(struct mesh_face *faces, struct mesh_face *room, int32 count,
                            int32 *digits);

/* Cuts a convex polygon before the camera (x, y, w as in mesh_point) to all borders; *count
   is what is left of it. room: 2 * POLYGON_VERTICES_MAX. An edge gives the same new vertices
   in either direction, each within 1/2^17. A polygon that would get too many vertices, which
   a convex one cannot, comes back empty. */
struct vertex *mesh_clip(struct vertex *room, struct vertex *vertices, int32 *count,
                         fix16 near_plane);

#endif
