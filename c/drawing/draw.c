/* From a polygon's span plan to its pixels. c/coverage/cover.c includes this file too, for polygons that are drawn
   front to back: its `cover` leaves hidden pixels out, and that of polygon_draw_whole is 0, so that others ask for
   nothing. */
#include "drawing/columns.h"
#include "drawing/deep.h"
#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/generated.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "drawing/plan.h"
#include "perspective/cubic.h"
#include "perspective/light.h"
#include "perspective/perspective.h"
#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/shading.h"

/* What leaves hidden pixels out of polygons that are drawn front to back. */
struct cover {
    /* Leaves hidden lines of a table that is just made without pixels. */
    void (*lines)(const struct setup *s);
    /* Draws the table of s->span by the kind of span of s. */
    void (*span)(struct setup *s);
    /* Draws lines of LEVEL_LINES, as perspective_draw. */
    void (*level)(const struct setup *s);
    /* Places lines that are drawn from their far ends. cuts: they may end early. */
    void (*far)(const struct setup *s, struct far_line *lines, int32 leftwards, int32 cuts);
};

/* Finds the polygon's steps and the starts on its left edges; a plane is there already. */
static enum polygon_result set_texturing(struct setup *s)
{
    const struct material *m = s->material;
    struct texturing *t = &s->texturing;

    if (m->gradients == GRADIENTS_PLANE) {
        if (m->start == START_TRUNCATED)
            texturing_crossings(t, s->edges.left, s->edges.lefts);
    } else if (s->count == 3) {
        plan_set_cuts(t, m->mapper);
        texturing_longest(t, &s->sides, &s->box, plan_chain(s));
        (m->start == START_SUBTEXEL ? texturing_pixels : texturing_edges)(
            t, s->edges.left, s->edges.lefts, s->box.right - s->box.left);
    } else {
        return POLYGON_NO_TRIANGLE;
    }
    s->span.dudx = t->dudx;
    s->span.dvdx = t->dvdx;
    s->edges.dudx = m->start == START_SUBTEXEL ? t->dudx : 0;
    s->edges.dvdx = m->start == START_SUBTEXEL ? t->dvdx : 0;
    return POLYGON_DRAWN;
}

/* Makes the scanline table in the form that a kind of span reads. */
static void make_lines(struct setup *s, enum span_kind kind)
{
    const struct line_routines *routines = &line_routines[kind_lines[kind]];

    outline_lines(s, EDGES_ARE_EXACT(s->material->edges) ? routines->exact_edges : routines->edges,
                  routines->scissor);
}

/* GRADIENTS_SCANLINE: first x of all lines, then u and v by two divides a line. */
static void set_ramps(struct setup *s)
{
    union plan_made *made = plan_room(s);
    struct ramp_plan plan;

    make_lines(s, SPAN_FILL);
    ramps_make(made->ramps.left, s->edges.left, s->edges.lefts);
    ramps_make(made->ramps.right, s->edges.right, s->edges.rights);
    plan.lines = s->edges.lines;
    plan.count = s->span.count;
    plan.left = made->ramps.left;
    plan.right = made->ramps.right;
    plan.steps = made->ramps.steps;
    plan.truncated = s->material->start == START_TRUNCATED;
    plan.packed = kind_lines[s->kind] == LINES_ADDX || s->kind == SPAN_AFFINE_SCANLINE;
    edge_ramp(&plan);
    s->span.steps = made->ramps.steps;
}

/* Returns non-zero if the mapper has a range that u and v of every pixel must stay in. */
static int32 has_range(const struct setup *s)
{
    return (s->material->mapper == MAPPER_GOURAUD || s->material->mapper == MAPPER_ARBITRARY)
        && !plan_is_flat(s);
}

/* Rounds u, v and the steps of a line up to the bits that its span keeps. */
static void raise_line(struct scanline *line, struct span_plan *span, const struct texturing *t)
{
    uint32 u = texturing_raised((uint32)line->start1 << 16 | line->start0, t->u_cut);

    line->start1 = (uint16)(u >> 16);
    line->start0 = (uint16)u;
    line->start2 = texturing_raised(line->start2, t->v_cut);
    span->dudx = (fix16)texturing_raised((uint32)span->dudx, t->u_cut);
    span->dvdx = (fix16)texturing_raised((uint32)span->dvdx, t->v_cut);
}

/* Draws the lines of the plan, unless they are only counted. */
static void draw_span(struct setup *s, const struct cover *cover)
{
    if (s->counts && s->renderer->only_counts)
        return;
    if (cover)
        cover->span(s);
    else
        kind_spans[s->kind](&s->span);
}

/* Draws line by line, for mappers whose spans have only one pair of steps. */
static void draw_each_line(struct setup *s, const struct cover *cover)
{
    struct span_plan *line = &s->span;
    int32 count = line->count;

    plan_set_cuts(&s->texturing, s->material->mapper);
    line->count = 1;
    for (int32 i = 0; i < count; i++) {
        line->lines = &s->edges.lines[i];
        line->dudx = line->steps[i].dudx;
        line->dvdx = line->steps[i].dvdx;
        if (line->lines->last >= line->lines->left) {
            raise_line(&s->edges.lines[i], line, &s->texturing);
            if (has_range(s))
                clamp_lines(s);
            draw_span(s, cover);
        }
        line->row += line->pitch;
    }
}

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

static void draw_affine(struct setup *s, const struct cover *cover)
{
    int32 scanline = !plan_is_flat(s) && s->material->gradients == GRADIENTS_SCANLINE;

    if (scanline) {
        set_ramps(s);
    } else {
        lower_by_steps(s);
        make_lines(s, s->kind);
        if (has_range(s))
            clamp_lines(s);
        if (s->kind == SPAN_GENERATED)
            generated_span(s);
        else if (s->kind == SPAN_KEYED_ROW)
            outline_opaque(s);
    }
    if (s->kind == SPAN_LIT_GOURAUD)
        shading_lines(s, plan_room(s)->shades);
    if (s->counts)
        count_lines(s, s->kind);
    if (scanline && s->kind != SPAN_AFFINE_SCANLINE)
        draw_each_line(s, cover);
    else
        draw_span(s, cover);
}

/* Draws a polygon whose outline and span are set. */
static enum polygon_result draw_inside(struct setup *s, const struct cover *cover)
{
    if (s->kind == SPAN_PERSPECTIVE) {
        if (draw_perspective(s, cover))
            return POLYGON_DRAWN;
        s->kind = s->affine;
        plan_set_plane(s);
    }
    if (!plan_is_flat(s) && s->material->gradients != GRADIENTS_SCANLINE) {
        const enum polygon_result result = set_texturing(s);

        if (result != POLYGON_DRAWN)
            return result;
    }
    draw_affine(s, cover);
    return POLYGON_DRAWN;
}

/* Returns non-zero for polygons that are drawn as fans of triangles. */
static int32 is_fan(struct renderer *renderer, const struct polygon *polygon,
                    const struct material *material)
{
    return polygon->count > 3 && polygon->planar != PLANAR_ALL
        && !polygon_is_planar(renderer, polygon, polygon->vertices, planes_asked(material));
}

#ifndef DRAW_INSIDE_ONLY

enum polygon_result polygon_draw_whole(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    enum polygon_result result;
    struct setup s;

    if (!is_polygon(polygon))
        return POLYGON_FEW;
    if (is_fan(renderer, polygon, material))
        return polygon_fan(polygon_draw, renderer, polygon, material);
    s.form = renderer->form;
    setup_begin(&s, renderer, polygon, material);
    result = plan_set_up(&s);
    return count_rules(&s, result == POLYGON_DRAWN ? draw_inside(&s, 0) : result);
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
    result = draw_inside(s, 0);
    s->kind = SPAN_PERSPECTIVE;
    return result;
}

#endif
