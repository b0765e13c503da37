/* From a polygon's span plan to its pixels. c/coverage/cover.c includes this file too, for polygons that are drawn
   front to back: its `cover` leaves hidden pixels out, and that of polygon_draw_whole is 0, so that others ask for
   nothing. */
#include "drawing/draw.h"
#include "drawing/fan.h"
#include "drawing/generated.h"
#include "drawing/lower.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "drawing/plan.h"
#include "drawing/ways.h"
#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/shading.h"

#ifndef DRAW_INSIDE_ONLY        /* there it stands before this file */
#define draw_perspective(s, cover) perspective_polygon(s)
#endif

/* Finds the polygon's steps and the starts on its left edges; a plane is there already. */
static enum polygon_result set_texturing(struct setup *s)
{
    const struct material *m = s->material;
    const struct texturing *t = &s->texturing;

    if (m->gradients != GRADIENTS_PLANE || m->start == START_TRUNCATED)
        return starts_find(s);
    s->span.dudx = s->edges.dudx = t->dudx;
    s->span.dvdx = s->edges.dvdx = t->dvdx;
    return POLYGON_DRAWN;
}

static void draw_affine(struct setup *s, const struct cover *cover)
{
    int32 scanline = !plan_is_flat(s) && s->material->gradients == GRADIENTS_SCANLINE;

    if (scanline) {
        scanline_make(s);
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
        scanline_draw(s, cover);
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

enum polygon_result setup_draw(struct setup *s)
{
    return draw_inside(s, 0);
}

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
    return count_rules(&s, result == POLYGON_DRAWN ? setup_draw(&s) : result);
}

#endif
