/* Which face is nearer, pixel by pixel: a z buffer that is valid only where faces are tested
   and what is drawn may hide them.

   q is near / (2 w), 2.30, near being the near plane: at most 2^29, the greater the nearer. On the screen it is
   a plane, found from a face's three corners as perspective's. At a line's first pixel it is off by at most
   DEPTH_OFF_LEAST and what error_part of depths.c derives from its gradient, and at each further pixel by half
   a unit more. A plane that may be off by more than the corners' q differ is not used: the face then has the middle
   of these everywhere. */
#ifndef DEPTHS_H
#define DEPTHS_H

#include "math/math.h"
#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "span/scanline.h"

enum depths_constants {
    DEPTH_FAR = -0x7fffffff - 1,        /* q where nothing has been drawn that may hide a tested face */
    DEPTH_NEAREST = 1 << 30,            /* q of a face that is before all tested ones near it */
    DEPTH_PARTS = 8,
    DEPTH_CORNERS = 64,
    /* Units of q: corners are off by a half each, 1.5 where a plane goes on beyond them; depths.c rounds five
       numbers down and depth_fill one. */
    DEPTH_OFF_LEAST = 10
};

/* A part of the frame in which tested faces are. */
struct depth_part {
    struct rectangle box;       /* pixels: all of theirs, and one beside them */
    fix16 near, far;            /* least and greatest w of their corners */
    int32 lacks;                /* 1: not all of these corners are kept, or one is far from the frame */
};

/* A corner of a tested face. */
struct depth_corner {
    int32 x, y;                 /* its place, rounded down to pixels */
    int32 q;
    const struct depth_part *part;
};

/* Memory for frames of one size. */
struct depths {
    int32 *z;                   /* q of each pixel, row by row: only inside the parts */
    struct scanline *bounds;    /* one a line of the frame, of which left and last are used: of a part that is cleared */
    struct frame aside;         /* where faces are drawn before they are tested: 1 byte a pixel */
    fix16 near_plane;
    fix16 far;                  /* the greatest w of all parts */
    int32 count;                /* parts, 0 to DEPTH_PARTS; each pixel of a tested face is in one that has it */
    struct depth_part parts[DEPTH_PARTS];
    int32 corners_count;
    struct depth_corner corners[DEPTH_CORNERS];
};

/* Everything depth_fill and depth_copy need. */
struct depth_plan {
    const struct scanline *lines;       /* left and last are read */
    int32 count;                        /* lines, 1 or more */
    uint8 *row;                         /* z of pixel -EDGE_BIAS of the first line */
    int32 pitch;                        /* bytes from line to line */
    struct number64 at, dx, dy;         /* q, 32.32 modulo 2^64, at that pixel, and its steps */
    int32 step;                         /* dx, rounded to the nearest */
    int32 left, last;                   /* depth_fill: the columns, + EDGE_BIAS; pixels beside them are left out */
    const uint8 *from;                  /* depth_copy: pixel -EDGE_BIAS of the first line */
    uint8 *to;
    int32 from_pitch, to_pitch;
};

/* src68k/depths: contracts there. */
void depth_fill(const struct depth_plan *plan);
void depth_copy(const struct depth_plan *plan);
void depth_copy_keyed(const struct depth_plan *plan);
int32 depth_convex(const struct vertex *vertices, int32 count);

/* Begins without parts. */
void depths_begin(struct depths *depths);

/* Takes the pixels of a polygon's box, and one beside it, into a part that meets them, or a new one. */
void depths_include(struct depths *depths, const struct vertex *vertices, int32 count);

/* Sets z inside the parts to DEPTH_FAR. */
void depths_clear(const struct depths *depths);

/* Sets a polygon's part of the frame and its depths; returns 0 if none of the frame is in it. */
int32 depth_part_set(struct depth_part *part, const struct frame *frame, const struct vertex *vertices, int32 count);

/* The same of a box around places on the screen; its depths are left as they are. */
int32 depth_part_place(struct depth_part *part, const struct frame *frame, fix16 x_low, fix16 x_high, fix16 y_low,
                       fix16 y_high);

/* Returns 1 if a polygon in a part may hide a tested face: depths_fill fills no other. */
int32 depths_meet(const struct depths *depths, const struct depth_part *own, int32 is_ordered);

static inline int32 depth_parts_meet(const struct rectangle *a, const struct rectangle *b)
{
    return a->left < b->right && b->left < a->right && a->top < b->bottom && b->top < a->bottom;
}

/* Returns 1 if all pixels in the box of a tested polygon have a z that is nearer than the polygon. */
int32 depths_hide(const struct depths *depths, const struct vertex *vertices, int32 count);

/* Returns 1 if all tested faces in a part are before the plane of q of a plan, whose `at` is at pixel -EDGE_BIAS of the
   frame's first line. */
int32 depths_are_before(const struct depths *depths, const struct depth_part *part, const struct depth_plan *plan);

static inline int32 depths_pitch(const struct depths *depths)
{
    return depths->aside.width * (int32)sizeof *depths->z;
}

/* Sets z to q of a polygon that has been drawn over all before, in the parts whose faces it may hide. is_ordered: only
   faces of the same tree, in its order, were drawn before, or none. A polygon behind all faces of a part, or whose
   plane
   is, is then left out there: at its pixels only what is behind it has set z, so that the part's faces are seen. */
void depths_fill(struct renderer *renderer, const struct depths *depths, const struct polygon *polygon,
                 const struct material *material, int32 is_ordered);

/* Copies the pixels of a polygon drawn aside whose q is z or more to the frame, and sets z to q; of keyed
   materials those that are not 0. Edges are exact. */
void depths_copy(struct renderer *renderer, const struct depths *depths, const struct polygon *polygon,
                 const struct material *material);

#endif
