#include "drawing/outline.h"

#include "polygon/counts.h"

/* Finds the box of lines and columns in the frame that the sides may cover, as polygon_find; returns
   0 if it is empty. */
static int32 find_box(struct rectangle *box, const struct sides *sides, const struct frame *frame)
{
    box->left = outline_most(FIX_CEIL(sides->x_low - EDGE_ERROR), 0);
    box->right = outline_least(FIX_CEIL(sides->x_high + EDGE_ERROR), frame->width);
    box->top = outline_most(FIX_CEIL(sides->top->y), 0);
    box->bottom = outline_least(FIX_CEIL(sides->bottom->y), frame->height);
    return box->left < box->right && box->top < box->bottom;
}

enum polygon_result outline_clipped(struct setup *s, int32 chain)
{
    enum polygon_result result = polygon_find(s, 0, OUTLINE_ALONE);
    struct sides *sides = &s->scratch->clipped_sides;
    const struct vertex *outline;
    struct clip_window window;
    int32 count = s->count;

    if (result != POLYGON_DRAWN)
        return result;
    window.left = window.top = -65536;
    window.right = s->frame->width << 16;
    window.bottom = s->frame->height << 16;
    outline = polygon_clip(s->scratch->clipped, s->vertices, &count, &window);
    if (outline != s->vertices) {
        s->outline_sides = sides;
        if (count < 3 || sides_find(sides, outline, count) != POLYGON_DRAWN
            || !find_box(&s->box, sides, s->frame))
            return POLYGON_EMPTY;
        edges_make(&s->edges, sides, &s->box, 0);
    }
    if (chain >= 0)
        plane_find(s, chain);
    return POLYGON_DRAWN;
}
