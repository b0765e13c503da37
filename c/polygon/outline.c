#include "polygon/outline.h"

#include "polygon/clip.h"
#include "polygon/lower.h"
#include "scene/scene_file.h"

static int32 minimum(int32 a, int32 b)
{
    return a < b ? a : b;
}

static int32 maximum(int32 a, int32 b)
{
    return a > b ? a : b;
}

static int32 set_box(struct rectangle *box, const struct sides *sides,
                     const struct frame *frame)
{
    box->left = maximum(FIX_CEIL(sides->x_low - EDGE_ERROR), 0);
    box->right = minimum(FIX_CEIL(sides->x_high + EDGE_ERROR), frame->width);
    box->top = maximum(FIX_CEIL(sides->top->y), 0);
    box->bottom = minimum(FIX_CEIL(sides->bottom->y), frame->height);
    return box->left < box->right && box->top < box->bottom;
}

/* Cuts the polygon a pixel outside the frame: no pixel centre is lost by rounding. Exact
   edges are not cut: a vertex on the border is rounded, and they would be exact no more. */
static enum polygon_result clip_vertices(struct setup *s)
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
        || !set_box(&s->box, &sides, s->frame))
        return POLYGON_EMPTY;
    return POLYGON_DRAWN;
}

enum polygon_result outline_find(struct setup *s)
{
    static struct scanline lines[SCENE_SIDE_MAX];
    static struct edge left[CLIP_VERTICES_MAX], right[CLIP_VERTICES_MAX];
    enum polygon_result result = sides_find(&s->sides, s->vertices, s->count);

    if (result != POLYGON_DRAWN)
        return result;
    if (!set_box(&s->box, &s->sides, s->frame))
        return POLYGON_EMPTY;
    s->outline = s->vertices;
    s->outline_count = s->count;
    s->outline_sides = &s->sides;
    if (s->material->clip == CLIP_VERTICES && s->material->edges != EDGES_EXACT
        && clip_vertices(s) != POLYGON_DRAWN)
        return POLYGON_EMPTY;
    s->edges.lines = lines;
    s->edges.left = left;
    s->edges.right = right;
    edges_make(&s->edges, s->outline_sides, &s->box, s->material->edges == EDGES_EXACT);
    return POLYGON_DRAWN;
}

void outline_lines(struct setup *s, void (*edges)(const struct edge_plan *plan),
                   void (*scissor)(const struct scissor_plan *plan))
{
    struct scissor_plan plan;

    edges(&s->edges);
    if (lower_to_no_scissor(s))
        return;
    plan.lines = s->edges.lines;
    plan.count = s->box.bottom - s->box.top;
    plan.width = s->frame->width;
    plan.dudx = s->span.dudx;
    plan.dvdx = s->span.dvdx;
    scissor(&plan);
}
