#include "coverage/coverage.h"

#include "drawing/outline.h"

void coverage_begin(struct coverage *c, const struct frame *frame)
{
    struct gap *gap = c->gaps, **row = c->rows;
    const int16 last = (int16)(EDGE_BIAS + frame->width - 1);

    c->end.left = c->end.last = 32767;
    c->end.next = &c->end;
    for (int32 i = frame->height; i > 0; i--, gap++) {
        gap->left = EDGE_BIAS;
        gap->last = last;
        gap->next = &c->end;
        *row++ = gap;
    }
    c->open = frame->height;
    c->left = c->room - frame->height;
    c->unused = 0;
    c->fresh = gap;
    c->overflow = 0;
    c->way = COVER_DIRECT;
    c->aside = (int32)(c->aside_pixels - frame->pixels);
}

/* Returns 1 if no pixel from left to last is in a gap. */
static inline int32 row_hides(const struct gap *gap, int32 left, int32 last)
{
    while (gap->last < left)
        gap = gap->next;
    return gap->left > last;
}

int32 coverage_hides_box(const struct coverage *c, const struct frame *frame, const struct rectangle *box)
{
    const int32 left = box->left + EDGE_BIAS, last = box->right + EDGE_BIAS;
    const int32 top = outline_most(box->top, 0), bottom = outline_least(box->bottom, frame->height - 1);
    const int32 middle = (top + bottom) >> 1;

    if (box->right < 0 || box->left >= frame->width)
        return 1;
    for (int32 i = middle; i <= bottom; i++)
        if (!row_hides(c->rows[i], left, last))
            return 0;
    for (int32 i = middle - 1; i >= top; i--)
        if (!row_hides(c->rows[i], left, last))
            return 0;
    return 1;
}

int32 coverage_hides(const struct coverage *c, const struct frame *frame,
                     const struct vertex *v, int32 count)
{
    fix16 x_low = v->x, x_high = v->x, y_low = v->y, y_high = v->y;
    struct rectangle box;

    for (count--, v++; count > 0; count--, v++) {
        if (v->x < x_low)
            x_low = v->x;
        else if (v->x > x_high)
            x_high = v->x;
        if (v->y < y_low)
            y_low = v->y;
        else if (v->y > y_high)
            y_high = v->y;
    }
    box.left = x_low >> 16;
    box.right = (x_high >> 16) + 1;
    box.top = y_low >> 16;
    box.bottom = (y_high >> 16) + 1;
    return coverage_hides_box(c, frame, &box);
}
