#include "perspective/perspective.h"

#include "math/math.h"

/* q must be at least this times its error, so that it cannot become 0 nor a quotient overflow. */
#define SURE 4
#define STEEP_2_14 (1 << 14)                /* in 2^16 units a pixel */
#define FLAT (8 << 16)                 /* texels a pixel: from the box's middle to a vertex u
                                          moves less than 8,192, and stays inside 16.16 */
#define TOO_STEEP (1 << 28)            /* SURE times this is above every q but the nearest's */

static int32 is_gentle(const struct number64 *gradient)
{
    return perspective_steepness(gradient) < STEEP_2_14;
}

/* Returns the units that a plane may be off after so many pixels. Its gradient, in 48.16, is off by
   2^-31 of itself and 3 / 2^16. */
static int32 error_part(const struct number64 *gradient, int32 pixels)
{
    int32 steep = perspective_steepness(gradient);

    if (steep < 1 << 16)
        return (steep * pixels >> 15) + (pixels >> 14) + 2;
    steep = (steep >> 15) + 1;
    return steep > TOO_STEEP / pixels ? TOO_STEEP : steep * pixels + (pixels >> 14) + 2;
}

static void shift_left(struct number64 *to, const struct number64 *from, int32 bits)
{
    to->hi = bits ? from->hi << bits | from->lo >> (32 - bits) : from->hi;
    to->lo = from->lo << bits;
}

/* Converts a plane in 48.16 to value * 2^scale; scale: 16 to 31. */
static void scale_plane(struct screen_plane *to, const struct screen_plane *from, int32 scale)
{
    shift_left(&to->at, &from->at, scale - 16);
    shift_left(&to->dx, &from->dx, scale - 16);
    shift_left(&to->dy, &from->dy, scale - 16);
}

/* Returns the units that a plane may be off after so many pixels and lines, and 2 more. */
static int32 plane_error(const struct screen_plane *plane, int32 right, int32 down)
{
    return 2 + error_part(&plane->dx, right) + error_part(&plane->dy, down);
}

/* Returns 1 if the least q is large compared with a plane's error. */
static int32 is_sure(int32 error, int32 least)
{
    return error < TOO_STEEP && least >= SURE * error;
}

/* Raises a plane by so many units, below 2^30. */
static void raise(struct screen_plane *plane, int32 units)
{
    const uint32 low = (uint32)units << 16;

    plane->at.lo += low;
    plane->at.hi += ((uint32)units >> 16) + (plane->at.lo < low);
}

int32 perspective_texels(struct perspective_plan *plan, struct depth *depth)
{
    const int32 shares = depth->is_triangle ? 1 : 3;
    struct texel_planes planes;
    int32 off_s, off_t;

    if (depth->has_texels)
        return 1;
    texel_planes_find(&planes, &depth->corners);
    off_s = plane_error(&planes.s, depth->right, depth->down);
    off_t = plane_error(&planes.t, depth->right, depth->down);
    if (!is_sure(off_s, depth->least) || !is_sure(off_t, depth->least))
        return 0;
    /* Raised so that s / q is never below u. q's error changes s by less than itself, as u less its
       base is below 2^scale. Rounding at each corner adds less than half a unit and one, times the
       pixel's shares of the corners. */
    raise(&planes.s, off_s + depth->off + 2 * shares + 2);
    raise(&planes.t, off_t + depth->off + 2 * shares + 2);
    plan->gentle = depth->gentle && is_gentle(&planes.s.dx) && is_gentle(&planes.t.dx);
    scale_plane(&plan->s, &planes.s, depth->scale);
    scale_plane(&plan->t, &planes.t, depth->scale);
    depth->has_texels = 1;
    return 1;
}

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
