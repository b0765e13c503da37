#include "perspective/perspective.h"

#include "math/math.h"

#define FLAT (8 << 16)                 /* texels a pixel: from the box's middle to a vertex u
                                          moves less than 8,192, and stays inside 16.16 */

/* Sets *to to u * q, q being 1.0. */
static void with_q_one(struct number64 *to, fix16 u)
{
    to->hi = (uint32)(u >> 2);
    to->lo = (uint32)u << 30;
}

/* Sets *to to the plane of u or v, at the box's corner. */
static void plane_of(struct screen_plane *to, uint32 at, fix16 ddx, fix16 ddy,
                     const struct texturing *t, const struct rectangle *box)
{
    with_q_one(&to->at, (fix16)at + ddx * (box->left - t->i) + ddy * (box->top - t->j));
    with_q_one(&to->dx, ddx);
    with_q_one(&to->dy, ddy);
}

static int32 is_flat(fix16 step)
{
    return fix_magnitude(step) < FLAT;
}

int32 perspective_of_texturing(struct perspective_plan *plan, const struct texturing *t,
                               const struct rectangle *box)
{
    if (!is_flat(t->dudx) || !is_flat(t->dudy) || !is_flat(t->dvdx) || !is_flat(t->dvdy)
        || box->right - box->left > PERSPECTIVE_LEVEL_WIDTH)
        return 0;
    plan->q.at.hi = plan->q_low = plan->q_high = PERSPECTIVE_ONE;
    plan->q.at.lo = plan->q.dx.hi = plan->q.dx.lo = plan->q.dy.hi = plan->q.dy.lo = 0;
    plane_of(&plan->s, t->u, t->dudx, t->dudy, t, box);
    plane_of(&plan->t, t->v, t->dvdx, t->dvdy, t, box);
    plan->u = plan->v = 0;
    plan->u_low = plan->v_low = -0x7fffffff;
    plan->u_high = plan->v_high = 0x7fffffff;
    plan->left = box->left;
    plan->gentle = 0;
    return 1;
}

fix16 perspective_reach(const struct perspective_plan *plan)
{
    fix16 farthest = plan->u_high > plan->v_high ? plan->u_high : plan->v_high;

    if (-plan->u_low > farthest)
        farthest = -plan->u_low;
    return -plan->v_low > farthest ? -plan->v_low : farthest;
}

int32 perspective_is_level(const struct perspective_plan *plan, const struct number64 *grows,
                           int32 width, int32 tolerance)
{
    uint32 part = grows->hi ? 0 - grows->lo : grows->lo;
    int32 off;

    if ((grows->hi && grows->hi != 0xffffffff) || part >> 16 == 0xffff)
        return 0;
    if (!part)
        return !grows->hi;
    /* in units of q: its change over the width, times texels */
    off = mul_shift(((perspective_reach(plan) >> 16) + 1) * width, (int32)(part >> 16) + 1, 16)
        + 1;
    return off <= (plan->q_low >> 16) * tolerance
                  + (int32)(((uint32)plan->q_low & 0xffff) * (uint32)tolerance >> 16);
}

static void add(struct number64 *to, const struct number64 *what)
{
    to->lo += what->lo;
    to->hi += what->hi + (to->lo < what->lo);
}

static void subtract(struct number64 *from, const struct number64 *what)
{
    from->hi -= what->hi + (from->lo < what->lo);
    from->lo -= what->lo;
}

static void turn(struct screen_plane *plane, int32 next)
{
    const struct number64 dx = plane->dx;

    if (next > 0)
        add(&plane->at, &dx);
    else if (next < 0)
        subtract(&plane->at, &plane->dy);
    plane->dx = plane->dy;
    plane->dy = dx;
}

void perspective_turn(struct perspective_plan *plan, int32 left, int32 next)
{
    turn(&plan->q, next);
    turn(&plan->s, next);
    turn(&plan->t, next);
    plan->left = left;
}
