/* Bodies that are tested pixel by pixel, beside a tree that is drawn from its nearest face on: those that have no visible
   pixel are found while the tree is drawn, and then neither transformed nor tested.

   A face that is drawn is in front of all that is behind its plane. A body waits while those that are drawn over pixels
   around it are so; if these pixels are covered before another one comes, it is hidden.

   The z buffer, too, would leave it none. q is near / (2 w), 2.30. Where the eye is 1/2^BODY_EDGE_ON of the near plane's
   depth or more away from a face's plane, q grows by less than 2^35 / f units a pixel, f pixels being the focal
   length, and a plane of q is off by less than 310 units: DEPTH_OFF_LEAST, and both of error_part over at most 9 f
   pixels. A line's pixels are off by half a frame's width more. Of the face drawn and of a body's this is less than
   2^11 together. A ray meets the body `margin` behind the plane or more, and w there is greater by a third of that,
   as f is a quarter of the frame's sides or more; x and y have their own if pixels are not as high as wide. So q differs
   by 2^29 near margin / (3 w^2) or more, which is 2^11 if margin is 2^-16 w^2 / near. Views are rotations, as the scene
   compiler makes them, x and y times f. */
#ifndef BODIES_H
#define BODIES_H

#include "mesh/near.h"

enum {
    BODY_EDGE_ON = 6,           /* log2 of a part of the near plane's depth */
    BODY_ROUNDED = 64           /* more than all roundings of a place or a distance here, 16.16 */
};

/* What changes from a tree's camera space to its own, 4.28: rows of x, y and depth. */
struct body_space {
    int32 rows[3][3];
    const struct scene_view *view;
    const struct scene_view *own;       /* of the last body, or 0; from its space, 2.30: */
    int32 factors[3][3];
};

enum body_state {
    BODY_PLAIN,                 /* nothing is known of what is before it */
    BODY_WAITING,               /* what is drawn at its pixels is in front of it */
    BODY_MET,                   /* was, until the face that is drawn now */
    BODY_KNOWN                  /* its pixels and its place in the tree's space are set */
};

/* An instance with TREE_Z. x, y, z 16.16. */
struct body {
    fix16 middle[3], half[3];   /* the box around its mesh, in the mesh's space */
    fix16 radius;               /* half the box's diagonal or more */
    int32 is_out;               /* 1: it has no visible pixel in this frame */
    /* In this frame: */
    fix16 at[3], reach[3];      /* the box around it in the tree's space: middle and half */
    fix16 margin;
    struct rectangle pixels;    /* around it, right and bottom included */
    uint32 mark;                /* its bit in marks of bodies */
    enum body_state state;
    int32 open;                 /* BODY_MET: pixels that it shares with the face and that were not covered */
    struct body *next;          /* in the frame, too */
};

/* Those of a scene, one an instance up to the last with TREE_Z. */
struct scene_bodies {
    struct body *each;
    uint32 first, end;          /* those that are looked for in this frame's tree; the same: none */
    uint32 marks;               /* of those that may be seen */
};

/* Sets the box around a mesh's points, one or more. */
void body_measure(struct body *body, const struct scene_point *points, uint32 count);

/* Sets the space of a tree's view. Returns 0 if no body is looked for: a wide view, whose focal length is less than a
   quarter of the frame's sides. */
int32 body_set_space(struct body_space *space, const struct near_walk *walk);

/* Returns 1 if a body with a view is outside a border of the frame; else sets its depth. */
int32 body_is_outside(const struct body *body, const struct scene_view *view, const struct near_frame *frame,
                      fix16 *depth);

/* Sets a body's box in the tree's space, its margin and pixels, at a depth. Returns 0 if it may be nearer than the near
   plane, or is too far away. */
int32 body_begin(struct body *body, const struct scene_view *view, const struct near_walk *walk,
                 struct body_space *space, fix16 depth);

/* Returns 1 if all of a body is behind a face's plane, -1 if all of it is in front of it, else 0. */
int32 body_side(const struct body *body, const struct scene_face *face);

/* Returns 1 if the eye is nearly on the plane of a mesh's face. */
int32 body_is_edge_on(const struct scene_face *face, uint32 count, const struct scene_view *view, fix16 near_plane);

#endif
