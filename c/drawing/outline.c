#include "drawing/outline.h"

struct outline_room outline_room;

enum polygon_result outline_clip(struct setup *s)
{
    static struct vertex room[2 * CLIP_VERTICES_MAX];
    static struct sides sides;
    struct clip_window window;

    window.left = window.top = -65536;
    window.right = s->frame->width << 16;
    window.bottom = s->frame->height << 16;
    s->outline = polygon_clip(room, s->vertices, &s->outline_count, &window);
    if (s->outline == s->vertices)
        return POLYGON_DRAWN;
    s->outline_sides = &sides;
    if (s->outline_count < 3
        || sides_find(&sides, s->outline, s->outline_count) != POLYGON_DRAWN
        || !outline_box(&s->box, &sides, s->frame))
        return POLYGON_EMPTY;
    return POLYGON_DRAWN;
}
