#include "perspective/tolerance.h"

#include "math/math.h"
#include "perspective/perspective.h"

/* Returns half the range of a triangle's u or v, rounded up. */
static fix16 half_range(const fix16 *value)
{
    fix16 low, high = vertex_range(value, 3, &low);

    high += low;
    return (high >> 1) - (low >> 1) + 1;
}

/* A point inside a triangle has shares a_i of the vertices, with sum 1, and Q = sum a_i q_i. Affine
   u is off by sum a_i (q_i / Q - 1) (u_i - c). sum a_i |q_i / Q - 1| is at most
   (greatest q - least q) / 2 least q = (greatest w - least w) / 2 least w. With c in the middle,
   |u_i - c| is at most half u's range. */
int32 tolerance_is_flat(const struct setup *s)
{
    fix16 least, range, u, v;

    if (s->count != 3)          /* otherwise the plane is that of three vertices: outside them
                                   shares have no bound */
        return 0;
    range = vertex_range(&s->vertices->w, 3, &least);
    if (range > least)
        return 0;
    u = half_range(&s->vertices->s);
    v = half_range(&s->vertices->t);
    return mul_div(u > v ? u : v, range, least) < 2 * s->material->tolerance;
}

/* A piece of n pixels, exact at both ends, is off by at most n^2 |u''| / 8, with u'' = -2 q' u' / q
   and |u'| <= (|S'| + |u - base| |q'|) / q. With a = |q'| / least q that is n^2 / 4 times a times
   the greatest |u'|. Returns a times the greatest |u'|, at most 2^23 or TOLERANCE_MAX; a is in 8.24, everything is
   rounded up. */
static fix16 bend(const struct perspective_plan *plan)
{
    int32 steep = perspective_steepness(&plan->q.dx) + 1;
    int32 s = perspective_steepness(&plan->s.dx), t = perspective_steepness(&plan->t.dx);
    int32 grows = (s > t ? s : t) + 1, a;
    fix16 slope;

    if (steep > plan->q_low >> 8 || grows > plan->q_low >> 2)
        return TOLERANCE_MAX;
    a = mul_div(steep, 1 << 24, plan->q_low) + 1;
    slope = mul_div(grows, 1 << 30, plan->q_low >> 2) + 1
          + mul_shift(perspective_reach(plan), a, 24) + 1;
    return mul_shift(slope, a, 24) + 1;
}

/* Returns the error of a setting's own straight pieces: what is allowed less would have shorter ones. */
static fix16 own_error(enum perspective setting)
{
    return setting == PERSPECTIVE_PIXEL ? PERSPECTIVE_STRAIGHT_PIXEL
         : setting == PERSPECTIVE_FINE ? PERSPECTIVE_STRAIGHT_FINE : 0;
}

int32 tolerance_is_coarser(struct setup *s)
{
    const struct perspective_plan *plan = s->perspective;
    fix16 tolerance = s->material->tolerance, pixel;

    if (perspective_is_level(plan, &plan->q.dx, s->box.right - s->box.left, tolerance)) {
        s->level = LEVEL_LINES;
        return 1;
    }
    if (s->setting == PERSPECTIVE_EVERY16 || tolerance < own_error(s->setting))
        return 0;
    pixel = bend(plan);         /* the products fit */
    if (pixel * (16 * 16 / 4) <= tolerance)
        s->setting = PERSPECTIVE_EVERY16;
    else if (s->setting != PERSPECTIVE_EVERY8 && pixel * (8 * 8 / 4) <= tolerance)
        s->setting = PERSPECTIVE_EVERY8;
    else
        return 0;
    return 1;
}

int32 tolerance_straight(const struct perspective_plan *plan, fix16 most)
{
    const fix16 pixel = bend(plan);
    int32 piece = PERSPECTIVE_PIECE_EXACT;

    while (piece >= PERSPECTIVE_PIECE_EVERY8 && pixel > (most - (4 << piece)) >> (2 * piece - 2))
        piece--;
    return piece >= PERSPECTIVE_PIECE_EVERY8 ? piece : 0;
}
