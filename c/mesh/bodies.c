#include "mesh/bodies.h"

#include "math/math.h"

enum {
    SPACE_BITS = 28,
    FOCAL_LEAST = 1 << 26,      /* a quarter squared, 2.30 */
    BOX_MOST = 32766,
    ONE_30 = 1 << 30
};

/* Returns factor * value, 2.30 times 16.16; most factors of levels' planes are 0 or 1. */
static inline fix16 times(int32 factor, fix16 value)
{
    return !factor ? 0 : factor == ONE_30 ? value : factor == -ONE_30 ? -value : mul_shift(factor, value, 30);
}

static fix16 along(const int32 *factors, const fix16 *v)
{
    return times(factors[0], v[0]) + times(factors[1], v[1]) + times(factors[2], v[2]);
}

void body_measure(struct body *body, const struct scene_point *p, uint32 count)
{
    const int32 *at = &p->x;
    fix16 most = 0, sum = 0;

    for (int32 k = 0; k < 3; k++, at++) {
        const int32 *value = at;
        fix16 low = *value, high = low;

        for (uint32 left = count; left; left--, value += sizeof *p / sizeof *value) {
            low = *value < low ? *value : low;
            high = *value > high ? *value : high;
        }
        body->middle[k] = (low >> 1) + (high >> 1);
        body->half[k] = (high >> 1) - (low >> 1) + 2;
        most = body->half[k] > most ? body->half[k] : most;
        sum += body->half[k] >> 1;
    }
    body->radius = sum + (most >> 1) + 2;       /* the largest, and halves of the others */
}

int32 body_set_space(struct body_space *space, const struct near_walk *walk)
{
    const struct near_frame *frame = &walk->frame;
    const int32 *row = &walk->view->xx;

    space->view = walk->view;
    space->own = 0;
    for (int32 k = 0; k < 2; k++, row += 3) {
        const uint32 side = (uint32)(k ? frame->height : frame->width);
        const int32 least = (int32)((side * side << 10 >> 2 * frame->guard) << 16);
        const int32 squared = mul_shift(row[0], row[0], 30) + mul_shift(row[1], row[1], 30)
                            + mul_shift(row[2], row[2], 30);

        if (squared < least || squared < FOCAL_LEAST)
            return 0;
        for (int32 i = 0; i < 3; i++)
            space->rows[k][i] = mul_div(row[i], 1 << SPACE_BITS, squared);
    }
    for (int32 i = 0; i < 3; i++)
        space->rows[2][i] = row[i] >> (30 - SPACE_BITS);
    return 1;
}

int32 body_is_outside(const struct body *body, const struct scene_view *view, const struct near_frame *frame,
                      fix16 *depth)
{
    const fix16 radius = body->radius + BODY_ROUNDED, *move = &view->x0;
    const int32 whole = 1 << frame->guard, *row = &view->xx;
    fix16 far;

    *depth = along(&view->zx, body->middle) + view->z0;
    far = *depth + radius;
    if (far < frame->near_plane)
        return 1;
    for (int32 k = 0; k < 2; k++, row += 3) {
        const int32 edge = ((k ? frame->height : frame->width) >> 1) + 2;
        const fix16 away = (fix16)fix_magnitude(along(row, body->middle) + *move++) - radius;

        if (away > mul_div(far, edge < whole ? edge : whole, whole))
            return 1;
    }
    return 0;
}

/* Sets factors from a body's space, which all billboards share, to the tree's. */
static void set_factors(struct body_space *space, const struct scene_view *own)
{
    const int32 *a = &own->xx, *b = space->own ? &space->own->xx : 0;
    int32 *to = &space->factors[0][0], left = 9;

    for (; b && left && *a == *b; left--)
        a++, b++;
    if (!left)
        return;
    space->own = own;
    for (int32 i = 0; i < 3; i++)
        for (int32 j = 0; j < 3; j++) {
            const int32 *from = &own->xx + j;

            *to++ = mul_shift(space->rows[0][i], from[0], SPACE_BITS)
                  + mul_shift(space->rows[1][i], from[3], SPACE_BITS)
                  + mul_shift(space->rows[2][i], from[6], SPACE_BITS);
        }
}

/* Sets the box around a body in the tree's space. */
static void set_place(struct body *body, const struct scene_view *own, struct body_space *space)
{
    const fix16 *eye = &space->view->eye_x;
    const int32 *factor = &space->factors[0][0];
    fix16 way[3];               /* from the eye, in the body's own space */

    set_factors(space, own);
    way[0] = body->middle[0] - own->eye_x;
    way[1] = body->middle[1] - own->eye_y;
    way[2] = body->middle[2] - own->eye_z;
    for (int32 i = 0; i < 3; i++, factor += 3) {
        body->at[i] = *eye++ + along(factor, way);
        body->reach[i] = BODY_ROUNDED + times((int32)fix_magnitude(factor[0]), body->half[0])
                       + times((int32)fix_magnitude(factor[1]), body->half[1])
                       + times((int32)fix_magnitude(factor[2]), body->half[2]);
    }
}

/* Sets the pixels around a body's box; returns 0 if it is too far away, or may be nearer than the near plane. */
static int32 set_pixels(struct body *body, const struct near_walk *walk)
{
    struct mesh_box box;
    int16 *low = &box.low_x, *high = &box.high_x;

    box.shift = walk->boxes->shift;
    for (int32 k = 0; k < 3; k++) {
        const int32 least = (body->at[k] - body->reach[k]) >> box.shift;
        const int32 most = ((body->at[k] + body->reach[k]) >> box.shift) + 1;

        if (least < -BOX_MOST || most > BOX_MOST)
            return 0;
        *low++ = (int16)least;
        *high++ = (int16)most;
    }
    return near_rectangle(walk, &box, &body->pixels);
}

int32 body_begin(struct body *body, const struct scene_view *view, const struct near_walk *walk,
                 struct body_space *space, fix16 depth)
{
    const fix16 far = depth + body->radius + BODY_ROUNDED, near_plane = walk->frame.near_plane;

    if (far >> 12 >= near_plane)        /* the margin would not fit */
        return 0;
    set_place(body, view, space);
    body->margin = (mul_div(far, far >> 9, near_plane) >> 7) + BODY_ROUNDED;
    return set_pixels(body, walk);
}

int32 body_side(const struct body *body, const struct scene_face *face)
{
    const int32 *const normal = &face->x;
    const fix16 away = along(normal, body->at) - face->distance;
    fix16 reach = body->margin;

    for (int32 k = 0; k < 3; k++)
        reach += times((int32)fix_magnitude(normal[k]), body->reach[k]);
    return away < -reach ? 1 : away > reach ? -1 : 0;
}

int32 body_is_edge_on(const struct scene_face *face, uint32 count, const struct scene_view *view, fix16 near_plane)
{
    for (; count; count--, face++)
        if (fix_magnitude(along(&face->x, &view->eye_x) - face->distance)
            < (uint32)(near_plane >> BODY_EDGE_ON) + BODY_ROUNDED)
            return 1;
    return 0;
}
