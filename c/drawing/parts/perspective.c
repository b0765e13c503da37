/* From the planes of a polygon in perspective to its pixels. c/coverage/cover.c includes this file too, for
   polygons that are drawn front to back: its `cover` leaves hidden pixels out; others have none. */
#include "drawing/columns.h"
#include "drawing/deep.h"
#include "drawing/lower.h"
#include "drawing/plan.h"
#include "drawing/ways.h"
#include "perspective/cubic.h"
#include "perspective/light.h"
#include "perspective/perspective.h"
#include "polygon/counts.h"

/* Makes the table of lines, unless it is made or nothing reads it but lines from afar whose edges are in the
   frame. Returns 1 if it is made. */
static int32 make_lines_read(struct setup *s, const struct cover *cover, int32 from_afar, int32 is_made)
{
    if (from_afar && !s->counts && !light_kind(s) && !cover && lower_to_no_scissor(s))
        return 0;
    if (!is_made)
        make_lines(s, SPAN_FILL);
    if (cover)
        cover->lines(s);
    s->perspective->lines = s->edges.lines;
    s->perspective->count = s->span.count;
    return 1;
}

/* How a polygon is drawn from the far ends of its lines. */
union afar {
    struct far_way way;         /* by settings with straight pieces */
    struct cubic_span cubics;   /* by the others */
};

/* Returns 1 if the polygon's lines are drawn from their far ends: no planes of s and t are needed. */
static int32 find_afar(union afar *afar, const struct setup *s, const struct depth *depth)
{
    if (s->frame->pixel_bytes != 1)     /* tables of lines are for texels of one byte */
        return 0;
    return perspective_has_pieces(s->setting)
         ? s->renderer->reciprocals && far_find(&afar->way, s, depth)
         : cubic_find(&afar->cubics, s, depth);
}

/* Returns 1 if the lines are bent, or straight with a tilt but so short that they cost less from their far ends: some
   840 cycles before the pixels with a tilt, and else 385, and 116 for each 16 pixels. */
static inline int32 may_be_afar(const struct setup *s)
{
    return !s->level || (s->level == LEVEL_LINES && s->perspective->tilt
                         && s->box.right - s->box.left <= PERSPECTIVE_TILT_LEAST);
}

/* Draws so. has_lines: they are in the scanline table; else edges are inside the frame. */
static void draw_afar(const struct setup *s, const struct cover *cover, const struct depth *depth,
                      union afar *afar, int32 has_lines)
{
    const int32 has_pieces = perspective_has_pieces(s->setting);
    struct far_line *lines;

    if (s->counts)
        count_lines(s, has_pieces ? SPAN_RECIPROCAL : SPAN_CUBIC);
    if (s->renderer->only_counts)
        return;
    lines = has_pieces ? far_lines(s, &afar->way, has_lines) : cubic_lines(s, has_lines);
    if (cover)
        cover->far(s, lines, (int32)s->perspective->q.dx.hi < 0, has_pieces);
    if (has_pieces)
        far_draw(s, depth, &afar->way, lines);
    else
        cubic_draw(s, &afar->cubics, lines);
}

/* Makes the edges that deep_draw has left out. */
static void make_edges(struct setup *s)
{
    if (!s->edges.lefts)
        edges_make(&s->edges, &s->sides, &s->box, EDGES_ARE_EXACT(s->material->edges));
}

/* Draws with perspective, from the depth that is found; edges may be left out. Returns 0 without drawing if the planes
   are too inexact. */
static int32 draw_deep(struct setup *s, const struct cover *cover, struct depth *depth)
{
    union afar afar;
    int32 from_afar, has_lines, is_made;

    lower_by_planes(s);
    perspective_find_level(s);
    if (s->level == LEVEL_COLUMNS && !perspective_texels(s->perspective, depth))
        return count_unsure(s);
    is_made = cover && s->level != LEVEL_COLUMNS;
    if (s->level == LEVEL_COLUMNS && !columns_draw(s))
        s->level = LEVEL_NOTHING;       /* they bend too much */
    if (s->level == LEVEL_COLUMNS && !light_kind(s))
        return 1;
    make_edges(s);
    /* if K lacks bits, straight lines are more accurate */
    from_afar = may_be_afar(s) && find_afar(&afar, s, depth) && !(s->level && afar.way.plan.less);
    if (from_afar)
        s->level = LEVEL_NOTHING;
    else if (!perspective_texels(s->perspective, depth))
        return count_unsure(s);
    has_lines = make_lines_read(s, cover, from_afar, is_made);
    if (from_afar)
        draw_afar(s, cover, depth, &afar, has_lines);
    else if (cover && s->level == LEVEL_LINES)
        cover->level(s);
    else if (s->level != LEVEL_COLUMNS)
        perspective_draw(s);
    if (light_kind(s))
        light_draw(s, plan_room(s)->shades);
    return 1;
}

/* Draws with perspective. Returns 0 without drawing if the planes are too inexact, too steep or too
   wide: affine spans then draw the polygon. */
static int32 draw_perspective(struct setup *s, const struct cover *cover)
{
    struct perspective_plan plan;
    struct depth depth;

    s->perspective = &plan;
    if (lower_w_is_constant(s)) {       /* rule CONSTANT_W is off: all lines are level */
        plan_set_plane(s);
        if (!perspective_of_texturing(&plan, &s->texturing, &s->box))
            return 0;
        depth.has_texels = 1;
    } else if (!perspective_depth(&depth, s)
               || (s->material->tolerance && !perspective_texels(&plan, &depth))) {
        return count_unsure(s);
    }
    return draw_deep(s, cover, &depth);
}

#ifndef DRAW_INSIDE_ONLY

int32 perspective_polygon(struct setup *s)
{
    return draw_perspective(s, 0);
}

enum polygon_result deep_rest(struct deep *deep, int32 is_sure)
{
    struct setup *s = &deep->s;
    enum polygon_result result;

    if (is_sure && draw_deep(s, 0, &deep->depth))
        return POLYGON_DRAWN;
    make_edges(s);
    s->kind = s->affine;
    plan_set_plane(s);
    result = setup_draw(s);
    s->kind = SPAN_PERSPECTIVE;
    return result;
}

#endif
