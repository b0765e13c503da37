#include "drawing/outline.h"

enum polygon_result outline_clip(struct setup *s)
{
    struct sides *sides = &s->scratch->clipped_sides;
    struct clip_window window;

    window.left = window.top = -65536;
    window.right = s->frame->width << 16;
    window.bottom = s->frame->height << 16;
    s->outline = polygon_clip(s->scratch->clipped, s->vertices, &s->outline_count, &window);
    if (s->outline == s->vertices)
        return POLYGON_DRAWN;
    s->outline_sides = sides;
    if (s->outline_count < 3
        || sides_find(sides, s->outline, s->outline_count) != POLYGON_DRAWN
        || !outline_box(&s->box, sides, s->frame))
        return POLYGON_EMPTY;
    return POLYGON_DRAWN;
}
