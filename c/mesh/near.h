/* Trees from the nearest faces on: only what is reached and may be seen is transformed. */
#ifndef NEAR_H
#define NEAR_H

#include "coverage/coverage.h"
#include "mesh/mesh.h"
#include "polygon/edges.h"

enum near_constants {
    NEAR_BORDERS = 5,
    NEAR_FACTOR_BITS = 13,      /* fraction bits of a border's factors */
    NEAR_NONE = -1,             /* mesh_near_face: no face is left */
    NEAR_FAR = 16383,           /* pixels: beyond every frame */
    NEAR_TESTED = 30             /* slots of a half space that is worth a look whether it is hidden */
};

/* Around the faces of a node and of all nodes of its front and back, rounded outwards: in units of
   16.16 << shift, which all nodes of a tree share. */
struct mesh_box {
    int16 low_x, low_y, low_z, high_x, high_y, high_z;
    int16 shift;
    uint16 slots;               /* of all these nodes, at most 65,535; 16 bytes: an index is a shift */
};

/* A border of the frame, or the near plane, in a tree's space: a box is outside if the sum of three products
   is below the limit. */
struct box_border {
    int16 x_at, x, y_at, y, z_at, z;    /* the coordinate's place in a box, in bytes; factor, 3.13 */
    int32 limit;
};

/* What is in a slot of a tree; face 0: nothing. */
struct near_slot {
    const struct scene_face *face;
    uint32 instance;
    const struct scene_corner *corners; /* of the face: their points are numbers of the tree's */
    const struct scene_point *points;   /* the tree's: each place once; 16 bytes */
};

/* What a walk's borders and rectangles are derived from. */
struct near_frame {
    int32 width, height;
    uint32 guard;
    fix16 near_plane;
};

/* A walk through a tree. */
struct near_walk {
    const struct scene_node *node;      /* where it goes on, or 0 */
    const struct scene_node **last;     /* behind the last step */
    const struct scene_node **steps;    /* scratch memory, two for each node */
    const struct scene_view *view;      /* its eye counts */
    const struct scene_node *nodes;     /* of the first box */
    const struct mesh_box *boxes;
    struct box_border borders[NEAR_BORDERS];
    /* Returns non-zero if nothing of a box can be visible, which is asked of half spaces beyond planes; may be 0. */
    int32 (*is_hidden)(const struct near_walk *walk, const struct mesh_box *box);
    struct near_frame frame;
};

/* A sum of three products and a move, 32.32, rounded to the nearest. */
struct near_row {
    fix16 move;
    uint32 half;                /* 1 << 31 */
    int32 x, y, z;              /* 2.30 */
};

/* The faces of a view that may be visible; their points are transformed where one needs them. */
struct near_face {
    struct near_row rows[3];
    int32 shifts[2];            /* 16 + guard, 16 - guard */
    fix16 near_plane, middle_x, middle_y;
    fix16 eye_x, eye_y, eye_z;
    int32 right, bottom;        /* the frame's last column and line */
    fix16 before, behind;       /* what makes the least of the points' x or y the first pixel that edges may cover, and
                                   the greatest the last one, rounded down: near_set_edges */
    struct gap *const *gaps;    /* of each of its lines the first */
    uint32 stamp;               /* of points that are transformed already */
    const struct near_slot *slot;       /* behind the next one */
    const struct near_slot *slots;      /* the last one */
    const struct scene_point *from;     /* the tree's first */
    struct mesh_point *points;
    fix16 above;                /* of the last face found: the eye's distance from its plane */
    int32 box[4];               /* left, right, top, bottom, both ends included: pixels that have all of its; not set if
                                   a point is not before the near plane */
};

/* src68k/mesh: contracts there. */
const struct scene_node *mesh_near(struct near_walk *walk);
int32 mesh_near_face(struct near_face *plan);
void mesh_project(struct vertex *vertices, int32 count, const struct near_frame *frame);

/* Sets the borders of a walk, whose view and frame are set, for boxes of a shift: a face in a box that is outside one
   has no pixel in the frame. */
void near_set_borders(struct near_walk *walk, int32 shift);

/* Sets before and behind, for edges that are up to `off` beyond the points, 1 to 65,535 units: pixels from
   ceil(least - off) to ceil(greatest + off) - 1. */
static inline void near_set_edges(struct near_face *plan, fix16 off)
{
    plan->before = 0xffff - off;
    plan->behind = off - 1;
}

/* Returns 1 if two views have the same factors, moves and eye. */
int32 near_same_place(const struct scene_view *a, const struct scene_view *b);

/* Sets rows, shifts, near plane, middle, eye, right and bottom. */
void near_set_view(struct near_face *plan, const struct near_frame *frame, const struct scene_view *view);

/* Sets *to to pixels, right and bottom included, that have all of a box's faces. Returns 0 if part of the box may be
   nearer than the near plane. */
int32 near_rectangle(const struct near_walk *walk, const struct mesh_box *box, struct rectangle *to);

#endif
