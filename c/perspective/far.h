/* Polygons with perspective that are drawn from the far ends of their lines. */
#ifndef PERSPECTIVE_FAR_H
#define PERSPECTIVE_FAR_H

#include "perspective/perspective.h"
#include "span/far.h"

/* K and C of a polygon: see span/far.h. */
struct far_plan {
    const struct plane_corners *corners;        /* the first is the top */
    const struct plane_corner *bottom;          /* the vector to the bottom */
    int32 scale;                        /* of s and t, 16 to 28 */
    int32 less;                         /* bits that K lacks, FAR_COARSE if C is coarser, else 0 */
    int32 top_u, top_v, bottom_u, bottom_v;     /* less their bases, as K */
    int32 ku, kv;                       /* less the bases, in 2^(less - FAR_K_BITS) units */
    uint32 cu, cv, dcu, dcv;            /* as a far_span's, of the first line */
    int32 rest_u, rest_v;               /* of the divisions for dcu and dcv by the height, 16.16 */
};

/* How a polygon is drawn. */
struct far_way {
    struct far_plan plan;
    int32 shift;                /* bits by which q may have to be shifted left, 1 by even spans */
    int32 even;
    int32 coarse;               /* 0, 1, or 2 if it is coarser */
    int32 to_u, to_v;           /* whole texels from K to the farthest, rounded up; */
    int32 part;                 /* for each, quarters of a unit by which lines are raised */
    const struct far_lengths *lengths;
};

/* Lengths of pieces. */
extern const struct far_lengths far_lengths[3];

/* src68k/polygon: contracts there. */
int32 far_asymptotes(struct far_plan *plan);
int32 far_constants(struct far_plan *plan, int32 bits);
int32 far_find(struct far_way *way, const struct setup *s, const struct depth *depth);

/* Fills in all of a span but its lines, of a way that far_find has found. */
void far_span_find(struct far_span *span, const struct setup *s, const struct depth *depth, const struct far_way *way);

typedef void far_routine(const struct far_span *span);

extern far_routine *const far_spans[2][3][2];   /* [even][coarse][q grows to the left] */

/* Draws its lines. */
void far_draw(const struct setup *s, const struct depth *depth, const struct far_way *way, struct far_line *lines);

/* Makes the span's table of lines in the scratch room. q: at the first pixel of the planes' first line, with its
   steps, in the format of the span. has_lines: lines are in the scanline table; else edges are inside the frame. */
struct far_line *far_make_lines(const struct setup *s, uint32 q, int32 dqdx, int32 dqdy, int32 has_lines);

/* Makes the lines of far_draw. */
static inline struct far_line *far_lines(const struct setup *s, const struct far_way *way, int32 has_lines)
{
    const struct screen_plane *q = &s->perspective->q;
    const uint32 at = q->at.hi;

    return far_make_lines(s, way->even ? 2 * at + (1u << 31) : at, (int32)(q->dx.hi << way->even),
                          (int32)(q->dy.hi << way->even), has_lines);
}

/* Returns the least q of a pixel; 0 if the polygon is too deep or too high, or q or the texels are too steep. */
static inline int32 far_least(const struct setup *s, const struct depth *depth)
{
    const struct perspective_plan *planes = s->perspective;
    const int32 pixels = s->box.right - s->box.left + s->span.count;
    const int32 steep = perspective_steepness(&planes->q.dx) + 1;
    /* steps are cut, and by rounded edges a pixel may be a step outside the polygon */
    const int32 least = planes->q_low - pixels - (EDGES_ARE_EXACT(s->material->edges) ? 0 : steep);

    return depth->gentle && least >= 1 << (29 - FAR_DEEP) && planes->q_high <= (1 << 30) + steep
        && depth->scale < FAR_K_SCALE && depth->down <= FAR_DOWN ? least : 0;
}

/* Sets the corners of a plan. */
static inline void far_begin_plan(struct far_plan *plan, const struct depth *depth)
{
    plan->corners = &depth->corners;
    plan->scale = depth->scale;
    plan->less = 0;
}

/* Returns the whole texels from K to the farther end of a range, rounded up. less: the bits that K lacks. */
static inline int32 far_farthest(int32 k, int32 less, fix16 low, fix16 high)
{
    const int32 at = k >> (16 + FAR_K_BITS - less), above = (high >> 16) - at, below = at - (low >> 16);

    return (above > below ? above : below) + 1;
}

/* Finds K and how far it is. Beyond `most` texels K lacks bits. Returns the texels, or 0 if K cannot be told. */
static inline int32 far_find_reach(struct far_way *way, const struct perspective_plan *planes, int32 most)
{
    struct far_plan *plan = &way->plan;
    int32 reach = 0;

    while (1) {
        if (far_asymptotes(plan)) {
            way->to_u = far_farthest(plan->ku, plan->less, planes->u_low, planes->u_high);
            way->to_v = far_farthest(plan->kv, plan->less, planes->v_low, planes->v_high);
            reach = way->to_u > way->to_v ? way->to_u : way->to_v;
        }
        if (plan->less || (reach && reach <= most))
            return reach;
        reach = 0;
        plan->less = FAR_COARSE;
    }
}

/* Converts u or v to the format of K. */
static inline int32 far_as_k(fix16 u, int32 less)
{
    return less ? u >> (less - FAR_K_BITS) : u << FAR_K_BITS;
}

/* Finds C. bits: as far_constants'. Returns 0 if it does not fit. */
static inline int32 far_find_c(struct far_plan *plan, const struct setup *s, int32 bits)
{
    const struct perspective_plan *planes = s->perspective;
    const struct sides *sides = &s->sides;

    plan->bottom = sides->middle_right ? &plan->corners->b : &plan->corners->a;
    plan->top_u = far_as_k(sides->top->s - planes->u + 1, plan->less);
    plan->top_v = far_as_k(sides->top->t - planes->v + 1, plan->less);
    plan->bottom_u = far_as_k(sides->bottom->s - planes->u + 1, plan->less);
    plan->bottom_v = far_as_k(sides->bottom->t - planes->v + 1, plan->less);
    return far_constants(plan, bits);
}

#endif
