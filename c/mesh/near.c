/* The borders of the frame in a tree's space, and views' factors in the form that mesh_near_face takes. */
#include "mesh/near.h"

#include "math/math.h"

/* Sums of products are below 0x60000000 in magnitude: limits beyond are never or always passed. */
#define LIMIT_MOST 0x70000000
/* What rounding takes from a sum: a factor is up to 1 unit too small, and a little for what it is made of; a
   coordinate is below 1 << 15, and there are three. */
#define SUM_OFF (1 << 17)
/* What rounding gives to a border's depth, 16.16: x, y and w of points are off by half a unit, those of clipped ones
   by a unit and a half; a border has at most one of each. Twice that. */
#define DEPTH_OFF 8

enum {
    FACTOR_SHIFT = 30 - NEAR_FACTOR_BITS,
    PLACE_VALUES = 15           /* of a view: factors, moves, eye */
};

/* Returns the sum below which a box is outside where depth 16.16 of its corner farthest inside, less its move, is. */
static int32 limit_of(fix16 move, int32 shift)
{
    const int32 up = NEAR_FACTOR_BITS - shift, most = LIMIT_MOST >> up, depth = -DEPTH_OFF - move;

    if (depth > most)
        return 0x7fffffff;
    if (depth < -most)
        return -0x7fffffff;
    return depth * (1 << up) - SUM_OFF;
}

/* Sets the place and factor of a coordinate. half: half the factor, 2.30; low, high: places of both ends. */
static void set_factor(int16 *to, int32 half, uint32 low, uint32 high)
{
    to[0] = (int16)(half < 0 ? low : high);
    to[1] = (int16)(half >> (FACTOR_SHIFT - 1));
}

/* Sets the border where the row, times sign, and the depth, times part, are 0 together. */
static void set_border(struct box_border *to, const int32 *row, const int32 *depth, int32 sign, int32 part,
                       int32 whole)
{
    struct mesh_box box;
    const int8 *at = (const int8 *)&box;
    int32 half[3];

    for (int32 k = 0; k < 3; k++)
        half[k] = sign * (row[k] >> 1) + (mul_div(depth[k], part, whole) >> 1);
    set_factor(&to->x_at, half[0], (uint32)((const int8 *)&box.low_x - at), (uint32)((const int8 *)&box.high_x - at));
    set_factor(&to->y_at, half[1], (uint32)((const int8 *)&box.low_y - at), (uint32)((const int8 *)&box.high_y - at));
    set_factor(&to->z_at, half[2], (uint32)((const int8 *)&box.low_z - at), (uint32)((const int8 *)&box.high_z - at));
}

void near_set_borders(struct near_walk *walk, int32 shift)
{
    const struct near_frame *frame = &walk->frame;
    static const int32 none[3];
    const struct scene_view *view = walk->view;
    const int32 whole = 1 << frame->guard;
    struct box_border *to = walk->borders;

    for (int32 upright = 0; upright < 2; upright++) {
        const int32 *row = upright ? &view->yx : &view->xx;
        const fix16 move = upright ? view->y0 : view->x0;
        /* two pixels beyond the frame's border, so that no rounding on the screen counts */
        const int32 edge = ((upright ? frame->height : frame->width) >> 1) + 2;
        const int32 part = edge < whole ? edge : whole;
        const fix16 away = mul_div(view->z0, part, whole);

        for (int32 sign = 1; sign >= -1; sign -= 2, to++) {
            set_border(to, row, &view->zx, sign, part, whole);
            to->limit = limit_of(sign * move + away, shift);
        }
    }
    set_border(to, none, &view->zx, 1, 1, 1);
    to->limit = limit_of(view->z0 - frame->near_plane, shift);
}

void near_set_view(struct near_face *plan, const struct near_frame *frame, const struct scene_view *view)
{
    const int32 *factor = &view->xx;
    const fix16 *move = &view->x0;

    for (int32 k = 0; k < 3; k++) {
        plan->rows[k].move = *move++;
        plan->rows[k].half = 0x80000000;
        plan->rows[k].x = *factor++;
        plan->rows[k].y = *factor++;
        plan->rows[k].z = *factor++;
    }
    plan->shifts[0] = 16 + (int32)frame->guard;
    plan->shifts[1] = 16 - (int32)frame->guard;
    plan->near_plane = frame->near_plane;
    plan->middle_x = frame->width << 15;
    plan->middle_y = frame->height << 15;
    plan->eye_x = view->eye_x;
    plan->eye_y = view->eye_y;
    plan->eye_z = view->eye_z;
    plan->right = frame->width - 1;
    plan->bottom = frame->height - 1;
}

/* A coordinate of points in the camera's space, 16.16. */
struct extent {
    int32 low, high;
};

/* Sets the extent of a box. */
static void set_extent(struct extent *to, const struct mesh_box *box, const int32 *row, fix16 move)
{
    const int16 *low = &box->low_x, *high = &box->high_x;
    const int32 down = NEAR_FACTOR_BITS - box->shift, off = (SUM_OFF >> down) + DEPTH_OFF;
    int32 least = 0, most = 0;

    for (int32 k = 3; k > 0; k--) {
        const int16 factor = (int16)(*row++ >> FACTOR_SHIFT);
        const int32 a = factor * *low++, b = factor * *high++;

        least += a < b ? a : b;
        most += a < b ? b : a;
    }
    to->low = move + (least >> down) - off;
    to->high = move + (most >> down) + off;
}

/* Returns pixels to the right of the middle, inside the guard band, of a coordinate at the depth at which it is farther
   from the middle. */
static int32 pixels_of(int32 coordinate, int32 near_depth, int32 far_depth, int32 outwards, uint32 guard)
{
    const int32 depth = (coordinate < 0) == (outwards < 0) ? near_depth : far_depth;
    const int32 most = 1 << guard;

    if (coordinate >= depth)
        return most;
    if (coordinate <= -depth)
        return -most;
    return mul_div(coordinate, most, depth);
}

int32 near_rectangle(const struct near_walk *walk, const struct mesh_box *box, struct rectangle *to)
{
    const struct scene_view *view = walk->view;
    const struct near_frame *frame = &walk->frame;
    struct extent x, y, w;

    set_extent(&w, box, &view->zx, view->z0);
    if (w.low < frame->near_plane)
        return 0;
    set_extent(&x, box, &view->xx, view->x0);
    set_extent(&y, box, &view->yx, view->y0);
    to->left = (frame->width >> 1) - 2 + pixels_of(x.low, w.low, w.high, -1, frame->guard);
    to->right = (frame->width >> 1) + 2 + pixels_of(x.high, w.low, w.high, 1, frame->guard);
    to->top = (frame->height >> 1) - 2 + pixels_of(y.low, w.low, w.high, -1, frame->guard);
    to->bottom = (frame->height >> 1) + 2 + pixels_of(y.high, w.low, w.high, 1, frame->guard);
    return 1;
}

int32 near_same_place(const struct scene_view *a, const struct scene_view *b)
{
    const int32 *one = &a->xx, *other = &b->xx;

    for (int32 left = PLACE_VALUES / 5; left > 0; left--, one += 5, other += 5)
        if (one[0] != other[0] || one[1] != other[1] || one[2] != other[2] || one[3] != other[3]
            || one[4] != other[4])
            return 0;
    return 1;
}
