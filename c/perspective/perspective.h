/* Perspective: the planes of 1/w, u/w and v/w over a polygon. */
#ifndef PERSPECTIVE_H
#define PERSPECTIVE_H

#include "polygon/kind.h"
#include "polygon/setup.h"
#include "span/perspective.h"

/* q of the nearest vertex. */
#define PERSPECTIVE_ONE (1 << 30)

/* A corner's values, or a vector: the differences between two corners' values. */
struct plane_corner {
    fix16 x, y;
    int32 q, s, t;              /* up to 2^30, in vectors below 2^31 */
};

/* Input of depth_plane_find and so on. */
struct plane_corners {
    struct plane_corner first, a, b;    /* a, b: vectors from the first, a x b > 0 */
    struct number64 area;               /* a x b, 32.32 */
    fix16 x, y;                         /* from the first corner to the pixel */
};

/* Input of corners_find. */
struct corner_source {
    const struct vertex *first, *a, *b;
    fix16 u, v;                         /* the bases of s and t */
    fix16 nearest;                      /* w */
    int32 scale;                        /* of s and t, 16 to 31 */
};

/* Output of texel_planes_find. */
struct texel_planes {
    struct screen_plane s, t;
};

/* What the planes of a polygon are found from. */
struct depth {
    struct plane_corners corners;
    int32 scale;                /* of s and t, as corner_source's */
    int32 is_triangle;
    int32 right, down;          /* how far pixels are from the first corner, pixels and lines */
    int32 off;                  /* units by which q may be off */
    int32 least;                /* of the corners' q, of their plane at the vertices if they are more */
    int32 gentle;               /* 1: no step of q reaches 2^30 units */
    int32 has_texels;           /* 1: the planes of s and t have been found */
};

/* src68k/polygon: contracts there. depth_plane_find and texel_planes_find: values at the pixel, and their
   steps to the next pixel and line; 48.16. */
void ranges_find(struct corner_source *source, struct perspective_plan *plan,
                 const struct vertex *vertices, int32 count);
void corners_find(struct plane_corners *corners, const struct corner_source *source);
void depth_plane_find(struct screen_plane *q, const struct plane_corners *corners);
void texel_planes_find(struct texel_planes *planes, const struct plane_corners *corners);

/* Spans for pixels of 1, 2 and 4 bytes: lines of pieces and of curves, and level lines ([chained]). */
typedef void perspective_routine(const struct perspective_span *span);
extern perspective_routine *const perspective_pieces[3], *const perspective_curves[3];
extern span_routine *const perspective_scanlines[2][3];

/* Returns 1 for settings with straight pieces. */
static inline int32 perspective_has_pieces(enum perspective setting)
{
    return setting == PERSPECTIVE_EVERY16 || setting == PERSPECTIVE_EVERY8;
}

/* Fills in the plane of q, the bases and ranges of a plan, for the box's pixels, and what other planes are
   found from. Returns 0 if q is too inexact, as q of a vertex is below 4 times its error: draw the polygon
   affine. w must not be constant. */
int32 perspective_depth(struct depth *depth, const struct setup *s);

/* Fills in the planes of s and t, once. Returns 0 if they are as inexact. src68k/polygon: contract there. */
int32 perspective_texels(struct perspective_plan *plan, struct depth *depth);

/* Fills in all of a plan for constant w, from the planes of u and v: q is 1 everywhere, and the picture is
   the affine one. Returns 0 if the planes are too steep or the box is too wide. */
int32 perspective_of_texturing(struct perspective_plan *plan, const struct texturing *t,
                               const struct rectangle *box);

/* Returns the upper half of a gradient's magnitude. */
static inline int32 perspective_steepness(const struct number64 *gradient)
{
    const int32 steep = (int32)gradient->hi;

    return steep >= 0 ? steep : gradient->lo ? ~steep : -steep;
}

/* Returns the largest distance of u and v from their bases. */
fix16 perspective_reach(const struct perspective_plan *plan);

/* Returns 1 if lines of at most `width` pixels, drawn as if their depth were constant, are off by
   at most `tolerance`, in 1/65536 texel (0 to TOLERANCE_MAX). */
int32 perspective_is_level(const struct perspective_plan *plan, const struct number64 *gradient,
                           int32 width, int32 tolerance);

/* Exchanges lines and columns of the planes. left: the new one; next: 1: before that, they go on to the next
   column; -1: behind that, back to the one before. */
void perspective_turn(struct perspective_plan *plan, int32 left, int32 next);

/* Finds s->level, unless a tolerance has, and tilt and steep of the plan. */
void perspective_find_level(struct setup *s);

/* Draws the lines of the plan with s->setting and s->level. */
void perspective_draw(struct setup *s);

/* Makes the lines of the plan by s->level. steps: room for their number. Returns the routine that draws them; 0 if
   they are only counted. */
span_routine *perspective_make_level(const struct setup *s, struct scanline_step *steps, struct span_plan *lines);

/* Draws the lines of the plan by s->level. steps: room for their number. */
void perspective_draw_level(const struct setup *s, struct scanline_step *steps);

#endif
