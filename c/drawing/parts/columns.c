#include "drawing/columns.h"

#include "drawing/outline.h"
#include "perspective/perspective.h"

/* Use of the scratch room. */
struct made {
    struct scanline_step steps[FRAME_SIDE_MAX];
    struct edge left[CLIP_VERTICES_MAX], right[CLIP_VERTICES_MAX];
};

SCRATCH_FITS(struct made);

/* Writes the vertices of an outline with x and y exchanged. */
static void turn(struct vertex *to, const struct vertex *from, int32 count)
{
    for (; count > 0; count--, from++, to++) {
        to->x = from->y;
        to->y = from->x;
        to->s = to->t = 0;
    }
}

/* Makes the outline's table with x and y exchanged, for a box of one column or more. */
static void turned_lines(struct setup *to, const struct setup *from)
{
    struct vertex *vertices = from->scratch->clipped;   /* exact edges are not clipped */

    to->renderer = from->renderer;
    to->material = from->material;
    to->off = from->off;
    to->counts = from->counts;
    to->setting = from->setting;
    to->applied = from->applied;
    to->outline_sides = &to->sides;
    turn(vertices, from->vertices, from->count);
    sides_find(&to->sides, vertices, from->count);
    edges_make_upright(&to->edges, &to->sides, &to->box);
    outline_lines(to, edge_flat_exact, scissor_flat);
}

int32 columns_draw(struct setup *s)
{
    struct made *made = (struct made *)s->scratch->room;
    struct perspective_plan *plan = s->perspective;
    const int32 left = s->box.left;
    struct setup turned;
    struct frame frame;
    int32 next;

    frame.width = s->frame->height;
    frame.pixel_bytes = 1;
    turned.frame = &frame;
    turned.box.left = s->box.top;
    turned.box.right = s->box.bottom;
    turned.box.top = outline_most(FIX_CEIL(s->sides.x_low), 0);
    turned.box.bottom = outline_least(FIX_CEIL(s->sides.x_high), s->frame->width);
    if (turned.box.top >= turned.box.bottom)
        return 1;
    next = turned.box.top > left;       /* the box may begin a column early, for rounded edges */
    turned.edges.lines = s->edges.lines;
    turned.edges.left = made->left;
    turned.edges.right = made->right;
    turned_lines(&turned, s);
    plan->lines = s->edges.lines;
    plan->count = turned.box.bottom - turned.box.top;
    perspective_turn(plan, turned.box.left, next);
    turned.span.row = s->span.row + EDGE_BIAS + turned.box.top - (s->box.top + EDGE_BIAS) * s->frame->pitch;
    turned.span.pitch = s->frame->pitch;
    turned.span.map = s->span.map;
    turned.perspective = plan;
    turned.level = LEVEL_COLUMNS;
    if (plan->steep && lines_bend(plan, turned.box.right - turned.box.left)) {
        perspective_turn(plan, left, -next);
        return 0;
    }
    perspective_draw_level(&turned, made->steps);
    s->applied = turned.applied;
    return 1;
}
