#include "coverage/touched.h"

void touched_begin(struct touched *touched, int32 width, int32 height)
{
    touched->rows_log = TOUCHED_ROWS_LOG;
    while (height > TOUCHED_BANDS << touched->rows_log)
        touched->rows_log++;
    touched->width = width;
    touched->height = height;
    touched->rest = 1;
    touched_clear(touched);
}

static void set_all(struct touched *touched, int32 right)
{
    struct touched_band *band = touched->bands;

    for (int32 left = TOUCHED_BANDS; left; left--, band++) {
        band->left = 0;
        band->right = (int16)right;
    }
}

void touched_clear(struct touched *touched)
{
    set_all(touched, 0);
}

void touched_fill(struct touched *touched)
{
    set_all(touched, touched->width);
}

static int32 is_full(const struct touched *touched)
{
    struct rectangle box;

    touched_next(touched, 0, &box);
    return !box.left && box.right == touched->width && box.bottom == touched->height;
}

struct touched *touched_ask(struct touched *touched)
{
    if (!touched->rest && is_full(touched))
        touched->rest = TOUCHED_REST;
    else if (touched->rest)
        touched->rest--;
    return touched->rest ? 0 : touched;
}

static inline void widen(struct touched_band *band, int32 left, int32 right)
{
    if (!band->right || left < band->left)
        band->left = (int16)left;
    if (right > band->right)
        band->right = (int16)right;
}

void touched_add(struct touched *touched, const struct rectangle *box)
{
    const int32 step = TOUCHED_STEP - 1;
    int32 left = box->left - TOUCHED_BEYOND, right = box->right + TOUCHED_BEYOND;
    int32 top = box->top - TOUCHED_BEYOND, bottom = box->bottom + TOUCHED_BEYOND;
    struct touched_band *band;

    left = left < 0 ? 0 : left & ~step;
    right = right > touched->width ? touched->width : (right + step) & ~step;
    if (right > touched->width)
        right = touched->width;
    top = top < 0 ? 0 : top;
    bottom = bottom > touched->height ? touched->height : bottom;
    if (left >= right || top >= bottom)
        return;
    top >>= touched->rows_log;
    bottom = (bottom - 1) >> touched->rows_log;
    for (band = &touched->bands[top]; top <= bottom; top++, band++)
        widen(band, left, right);
}

void touched_join(struct touched *touched, const struct touched *other)
{
    const struct touched_band *from = other->bands;
    struct touched_band *band = touched->bands;

    for (int32 left = TOUCHED_BANDS; left; left--, band++, from++)
        if (from->right)
            widen(band, from->left, from->right);
}

void touched_copy(struct touched *touched, const struct touched *other)
{
    touched_clear(touched);
    touched_join(touched, other);
}

struct rectangle *touched_next(const struct touched *touched, int32 from, struct rectangle *box)
{
    const int32 rows = 1 << touched->rows_log, height = touched->height;
    const struct touched_band *band = &touched->bands[from >> touched->rows_log], *first;

    for (; from < height && !band->right; band++)
        from += rows;
    first = band;
    box->left = box->right = box->top = box->bottom = from;
    if (from >= height)
        return box;
    box->left = first->left;
    box->right = first->right;
    while (from < height && band->left == first->left && band->right == first->right) {
        from += rows;
        band++;
    }
    box->bottom = from < height ? from : height;
    return box;
}

void touched_box(const struct touched *touched, struct rectangle *box)
{
    struct rectangle run;

    touched_next(touched, 0, box);
    for (touched_next(touched, box->bottom, &run); run.top < run.bottom; touched_next(touched, run.bottom, &run)) {
        if (run.left < box->left)
            box->left = run.left;
        if (run.right > box->right)
            box->right = run.right;
        box->bottom = run.bottom;
    }
}
