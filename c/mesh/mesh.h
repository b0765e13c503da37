/* Meshes from their points to polygons on the screen. */
#ifndef MESH_H
#define MESH_H

#include "mesh/records.h"
#include "polygon/polygon.h"

/* The borders inside which points are projected: the near plane and |x|, |y| <= z, the guard
   band. */
enum mesh_outside {
    MESH_NEAR = 1,              /* z below the near plane */
    MESH_LEFT = 2,              /* x + z below 0 */
    MESH_RIGHT = 4,             /* z - x below 0 */
    MESH_ABOVE = 8,             /* y + z below 0 */
    MESH_BELOW = 16             /* z - y below 0 */
};

/* A point in camera space, and on the screen if it is inside all borders. */
struct mesh_point {
    fix16 x, y, w;              /* w: z, the depth */
    fix16 screen_x, screen_y;   /* written where outside is 0; by mesh_near_face unless it has MESH_NEAR */
    uint32 outside;             /* enum mesh_outside, ored */
    uint32 stamp, spare;        /* mesh_near_face's; 32 bytes: an index is a shift */
};

/* A mesh's point in 16 bits: coordinates of scene_point * MESH_UNIT16 / the largest of the mesh,
   rounded to the nearest. */
struct mesh_point16 {
    int32 product;              /* x * y */
    int16 x, y, spare, z;
};

/* A point as triangles' routines take it, a struct snapped_vertex that is not lit. u and v are set for
   instances with MESH_LINKED. Nothing is set for a point whose mark is 0. */
struct mesh_place {
    int32 place;                /* x and y of struct snapped_vertex; negative: out of range */
    int32 u, v;
    int32 depth;                /* mesh_transform's, in the unit of its view, or a mesh_point's w */
};

/* Marks of a mesh's points, a byte each: those that are not 0 are needed. Behind the last is
   MARKS_END. */
enum { MARKED = 0xff, MARKS_END = 1 };

/* In flags of struct mesh_placed: its triangles' vertices are its places. They have no values, or those
   of the normal of the same number. */
enum { MESH_LINKED = MESH_FLAGS };

/* Values from a normal: s and t of an environment, shade of a light. */
struct mesh_attributes {
    fix16 s, t, shade;
    uint32 spare;               /* 16 bytes: an index is a shift */
};

struct transform_plan {
    const struct mesh_point16 *from;
    const uint8 *marks;         /* of one point or more */
    const struct scene_view16 *view;
    struct mesh_place *to;
    uint32 right, bottom;       /* largest x and y, 1/16 pixel */
};

struct wide_plan {
    const struct scene_point *from;
    int32 count;                /* 1 or more */
    const struct scene_view *view;
    struct mesh_point *to;
    fix16 near_plane;
    uint32 guard;               /* as in the scene's header */
    fix16 middle_x, middle_y;   /* of the frame */
};

/* Sums of products: base + (x n.x + y n.y + z n.z) / 32, clamped to low to high. */
struct attribute_plan {
    const struct scene_normal *from;
    int32 count;                /* 1 or more */
    fix16 *to;                  /* a field of the first mesh_attributes; the others follow */
    const int16 *factors;       /* x, y, z: 9.7 */
    fix16 base, low, high;
};

/* Values from normals to places. */
struct values_plan {
    const struct scene_normal *from;
    const uint8 *marks;         /* of one point or more */
    struct mesh_place *to;
    const int16 *factors;       /* mesh_mirror: x, y, z of s, then of t; mesh_shade: of the light */
    fix16 low, high;            /* of mesh_shade */
    int32 shift;                /* of mesh_mirror: s and t >> it are texels */
};

/* Shades by depth: `bright` up to the depth `near`, `dark` from `far` on, evenly between. All 16.16; far
   is above near, bright not below dark. */
struct mesh_fog {
    fix16 near, far;
    fix16 dark, bright;
};

/* An instance in a frame. */
struct mesh_placed {
    const struct scene_mesh *mesh;
    const struct scene_corner *corners;         /* the mesh's first */
    const struct material *material;
    const struct scene_view *view;
    const struct scene_view16 *view16;          /* 0: transformed with 32-bit operands */
    struct mesh_point *points;                  /* with a view16 only those that are off the screen */
    const struct mesh_place *places;            /* with a view16 those that are marked; else all, if
                                                   routines for triangles may draw it */
    const struct mesh_attributes *attributes;
    uint32 flags;
    struct mesh_fog fog;        /* with MESH_FOG */
};

/* A face to draw. */
struct mesh_face {
    uint32 order;               /* its greatest depth, inverted: the least order is drawn first; of faces drawn from
                                   the nearest on the marks of bodies that they may hide */
    struct mesh_face *next;     /* mesh_sort's or mesh_walk's */
    const struct scene_face *face;
    const struct mesh_placed *placed;
    const struct mesh_place *a, *b, *c, *d;     /* mesh_orders': its corners, if routines for
                                                   triangles may draw it, else a is 0; d is 0 if
                                                   there are three */
};

struct faces_plan {
    const struct scene_face *from;
    int32 count;                /* 1 or more */
    const struct mesh_placed *placed;
    struct mesh_face *to;
    uint8 *marks;               /* mesh_faces: of the mesh's points */
};

struct orders_plan {
    struct mesh_face *faces;
    int32 count;                /* 1 or more */
    const struct mesh_placed *placed;           /* of all of them */
    int32 depth_shift;          /* of its places' depths */
};

/* The point where a border cuts an edge. */
struct cut_plan {
    struct vertex *to;
    const struct vertex *inside, *outside;
    int32 part;                 /* the inner end's depth inside the border, 0 or more */
    uint32 whole;               /* the difference of both ends' depths, more than part */
};

/* Memory for the meshes that are drawn together. */
struct mesh_work {
    struct mesh_placed *placed;
    struct mesh_point *points;
    struct mesh_place *places;
    struct mesh_attributes *attributes;
    struct mesh_face *faces;
    uint8 *marks;               /* of one instance's points, in whole longwords */
    struct mesh_face **slots;   /* of a tree, all 0 before and after mesh_walk; 0 if no scene's */
    const struct scene_node **steps;    /* two for each node of a tree */
};

/* src68k/mesh: contracts there. */
int32 mesh_transform(const struct transform_plan *plan);
void mesh_transform_wide(const struct wide_plan *plan);
void mesh_attributes(const struct attribute_plan *plan);
void mesh_mirror(const struct values_plan *plan);
void mesh_shade(const struct values_plan *plan);
int32 mesh_faces(const struct faces_plan *plan);
int32 mesh_faces_wide(const struct faces_plan *plan);
void mesh_orders(const struct orders_plan *plan);
uint32 mesh_vertices(const struct mesh_face *face, struct vertex *to);
void mesh_cut(const struct cut_plan *plan);

/* Sets the shades of vertices by their depths, within half a unit. */
void mesh_fade(struct vertex *v, int32 count, const struct mesh_fog *fog);

/* Returns the enum planar_values of a face with such shades that need no test, and PLANAR_ROUGH if shades do. */
uint32 mesh_fade_planar(const struct vertex *v, int32 count);

/* Converts a mesh's points to 16 bits. */
void mesh_points16(struct mesh_point16 *to, const struct scene_point *from, int32 count);

/* A tree, whose faces that are seen are in its slots; the other slots are 0. */
struct walk_plan {
    const struct scene_node *root;
    const struct scene_view *view;      /* its eye counts */
    struct mesh_face **slots;
    const struct scene_node **steps;    /* scratch memory, two for each node */
};

/* Puts the faces that are seen of an instance into its tree's slots. face: the mesh's first; slot:
   its; count: of those seen, which are in the mesh's order. */
void mesh_fill(struct mesh_face **slots, const struct scene_slot *slot, const struct scene_face *face,
               struct mesh_face *seen, int32 count);

/* Sets the slots of a tree to 0 and returns a list of the faces in them, back to front: src68k/mesh. */
struct mesh_face *mesh_walk(const struct walk_plan *plan);

enum {
    MESH_SORT_BUCKETS = 256,
    MESH_SORT_STEPS_LOG = 4     /* log2: with more steps a face than this, a merge sort is used */
};

struct mesh_face *mesh_spread(struct mesh_face *faces, int32 count, struct mesh_face **at);

/* Sorts by order, those of the same order as they came; returns the first of a list. at: scratch
   memory, MESH_SORT_BUCKETS. */
struct mesh_face *mesh_sort(struct mesh_face *faces, int32 count, struct mesh_face **at);

/* Clips a convex polygon in camera space (x, y, w as in mesh_point) to all borders; sets *count to
   the number of vertices left. outside: the borders, enum mesh_outside, that a vertex is outside of.
   room: 2 * POLYGON_VERTICES_MAX. An edge gives the same new vertices in either direction, each within
   1/2^17. A polygon that would get too many vertices, which a convex one cannot, becomes empty. */
struct vertex *mesh_clip(struct vertex *room, struct vertex *vertices, int32 *count,
                         fix16 near_plane, uint32 outside);

#endif
