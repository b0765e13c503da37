/* Steps of each line by two divides. */
#include "drawing/material.h"
#include "drawing/plan.h"
#include "drawing/ways.h"
#include "polygon/counts.h"
#include "polygon/texturing.h"

void scanline_make(struct setup *s)
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

void scanline_draw(struct setup *s, const struct cover *cover)
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
