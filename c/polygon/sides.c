#include "polygon/sides.h"

#include "polygon/plane.h"

void vertex_difference(struct vertex *out, const struct vertex *a, const struct vertex *b)
{
    out->x = a->x - b->x;
    out->y = a->y - b->y;
    out->s = a->s - b->s;
    out->t = a->t - b->t;
}

/* Below POLYGON_FAR in size: one comparison, since it is made without a sign. */
#define IN_RANGE(value) \
    ((uint32)(value) + (POLYGON_FAR * 65536u - 1) < 2 * (POLYGON_FAR * 65536u) - 1)

int32 sides_measure(struct sides *sides, const struct vertex *vertices, int32 count)
{
    const struct vertex *top = vertices, *bottom = vertices, *vertex = vertices;
    fix16 x_low = vertices->x, x_high = x_low, y_low = vertices->y, y_high = y_low;

    sides->top = sides->bottom = 0;
    for (int32 i = 0; i < count; i++, vertex++) {
        fix16 x = vertex->x, y = vertex->y;

        if (!IN_RANGE(x) || !IN_RANGE(y) || !IN_RANGE(vertex->s) || !IN_RANGE(vertex->t))
            return 0;
        if (x < x_low)
            x_low = x;
        if (x > x_high)
            x_high = x;
        if (y < y_low || (y == y_low && x < top->x)) {
            top = vertex;
            y_low = y;
            sides->top = i;
        }
        if (y > y_high || (y == y_high && x < bottom->x)) {
            bottom = vertex;
            y_high = y;
            sides->bottom = i;
        }
    }
    sides->x_low = x_low;
    sides->x_high = x_high;
    return 1;
}

/* Whether `vertex` is farther from the line than the apex so far; of equals the
   topmost, then the leftmost, so that the order of the vertices does not matter. */
static int32 farther(const struct wide *size, const struct vertex *vertex,
                     const struct wide *largest, const struct vertex *apex)
{
    if (size->hi != largest->hi)
        return size->hi > largest->hi;
    if (size->lo != largest->lo)
        return size->lo > largest->lo;
    return vertex->y < apex->y || (vertex->y == apex->y && vertex->x < apex->x);
}

int32 sides_orient(struct sides *sides, const struct vertex *vertices, int32 count)
{
    const struct vertex *top = &vertices[sides->top];
    struct vertex down, across;
    struct wide size, largest = {0, 0};
    int32 sign = 0, apex_after, bottom_after;

    sides->apex = sides->top;
    down.x = vertices[sides->bottom].x - top->x;
    down.y = vertices[sides->bottom].y - top->y;
    for (int32 i = 0; i < count; i++) {
        int32 turn;

        if (i == sides->top || i == sides->bottom)
            continue;
        across.x = vertices[i].x - top->x;
        across.y = vertices[i].y - top->y;
        turn = cross(&down, &across, &size);
        if (turn && farther(&size, &vertices[i], &largest, &vertices[sides->apex])) {
            largest = size;
            sign = turn;
            sides->apex = i;
        }
    }
    if (!sign)
        return 0;
    apex_after = sides->apex - sides->top;
    if (apex_after < 0)
        apex_after += count;
    bottom_after = sides->bottom - sides->top;
    if (bottom_after < 0)
        bottom_after += count;
    /* y runs down: a positive turn means that the apex lies to the left. */
    sides->left_step = (sign > 0) == (apex_after < bottom_after) ? 1 : -1;
    return 1;
}
