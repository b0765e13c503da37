#include "polygon/sides.h"

#include "polygon/plane.h"

int32 fix_ceil(fix16 x)
{
    return (x + 0xffff) >> 16;
}

void vertex_difference(struct vertex *out, const struct vertex *a, const struct vertex *b)
{
    out->x = a->x - b->x;
    out->y = a->y - b->y;
    out->s = a->s - b->s;
    out->t = a->t - b->t;
    out->shade = a->shade - b->shade;
}

static int32 in_range(fix16 value)
{
    const fix16 far = POLYGON_FAR * 65536;

    return value > -far && value < far;
}

int32 sides_measure(struct sides *sides, const struct vertex *vertices, int32 count)
{
    const struct vertex *top = vertices, *bottom = vertices, *vertex = vertices;

    sides->top = sides->bottom = 0;
    sides->x_low = sides->x_high = vertices->x;
    for (int32 i = 0; i < count; i++, vertex++) {
        if (!in_range(vertex->x) || !in_range(vertex->y)
            || !in_range(vertex->s) || !in_range(vertex->t))
            return 0;
        if (vertex->x < sides->x_low)
            sides->x_low = vertex->x;
        if (vertex->x > sides->x_high)
            sides->x_high = vertex->x;
        if (vertex->y < top->y || (vertex->y == top->y && vertex->x < top->x)) {
            top = vertex;
            sides->top = i;
        }
        if (vertex->y > bottom->y || (vertex->y == bottom->y && vertex->x < bottom->x)) {
            bottom = vertex;
            sides->bottom = i;
        }
    }
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
