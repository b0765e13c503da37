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
    c->deep_is_set = 0;
    c->aside = (int32)(c->aside_pixels - frame->pixels);
}

/* Returns 1 if no pixel from left to last is in a gap. */
static inline int32 row_hides(const struct gap *gap, int32 left, int32 last)
{
    while (gap->last < left)
        gap = gap->next;
    return gap->left > last;
}

/* Returns 1 if all pixels of the frame in a box are covered. */
static inline int32 box_hides(const struct coverage *c, const struct frame *frame, int32 x, int32 y, int32 right,
                              int32 bottom)
{
    const int32 left = x + EDGE_BIAS, last = right + EDGE_BIAS;
    const int32 top = outline_most(y, 0), low = outline_least(bottom, frame->height - 1);
    const int32 middle = (top + low) >> 1;
    struct gap *const *row = &c->rows[middle];

    if (right < 0 || x >= frame->width || top > low)
        return 1;
    for (int32 i = low - middle; i >= 0; i--)
        if (!row_hides(*row++, left, last))
            return 0;
    row = &c->rows[middle];
    for (int32 i = middle - top; i > 0; i--)
        if (!row_hides(*--row, left, last))
            return 0;
    return 1;
}

int32 coverage_hides_box(const struct coverage *c, const struct frame *frame, const struct rectangle *box)
{
    return box_hides(c, frame, box->left, box->top, box->right, box->bottom);
}

int32 coverage_open(const struct coverage *c, const struct frame *frame, const struct rectangle *box)
{
    const int32 left = box->left + EDGE_BIAS, last = box->right + EDGE_BIAS;
    const int32 top = outline_most(box->top, 0), bottom = outline_least(box->bottom, frame->height - 1);
    struct gap *const *row = &c->rows[top];
    int32 open = 0;

    for (int32 lines = bottom - top; lines >= 0; lines--) {
        const struct gap *gap = *row++;

        while (gap->last < left)
            gap = gap->next;
        for (; gap->left <= last; gap = gap->next)
            open += outline_least(gap->last, last) + 1 - outline_most(gap->left, left);
    }
    return open;
}

int32 coverage_hides(const struct coverage *c, const struct frame *frame,
                     const struct vertex *v, int32 count)
{
    fix16 x_low = v->x, x_high = v->x, y_low = v->y, y_high = v->y;

    for (count--, v++; count > 0; count--, v++) {
        const fix16 x = v->x, y = v->y;

        if (x < x_low)
            x_low = x;
        else if (x > x_high)
            x_high = x;
        if (y < y_low)
            y_low = y;
        else if (y > y_high)
            y_high = y;
    }
    return box_hides(c, frame, x_low >> 16, y_low >> 16, (x_high >> 16) + 1, (y_high >> 16) + 1);
}
