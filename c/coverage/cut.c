/* Lines are cut where they are hidden: a line's table entry becomes its first visible part, and its other
   parts are drawn after the table, those of neighbouring lines together. u and v of a part's first pixel are
   those that the span would step to, so that it has the same texels. */
#include "coverage/cut.h"

#include "polygon/kind.h"

/* Cuts all lines of a table to the parts of the last scan. steps: of each line, or 0. */
static void cut_table(struct coverage *c, struct parts_plan *plan, struct scanline *lines,
                      const struct scanline_step *steps)
{
    c->second.count = c->further.count = 0;
    plan->parts = c->parts;
    plan->end = c->parts_end;
    plan->lines = lines;
    plan->steps = steps;
    plan->second = &c->second;
    plan->further = &c->further;
    coverage_cut(plan);
}

/* Draws lines that were cut off. */
static void draw_lines(const struct cut_lines *from, struct span_plan *plan,
                       void (*routine)(const struct span_plan *))
{
    uint8 *const row = plan->row;
    int32 first = 0;

    while (first < from->count) {
        int32 end = first + 1;

        while (end < from->count && from->rows[end] == from->rows[end - 1] + 1)
            end++;
        plan->lines = &from->lines[first];
        plan->steps = &from->steps[first];
        plan->count = end - first;
        plan->row = row + from->rows[first] * plan->pitch;
        routine(plan);
        first = end;
    }
    plan->row = row;
}

static void draw_all(struct coverage *c, struct span_plan *plan,
                     void (*routine)(const struct span_plan *))
{
    routine(plan);
    draw_lines(&c->second, plan, routine);
    draw_lines(&c->further, plan, routine);
}

void cut_span(struct coverage *c, struct setup *s)
{
    struct parts_plan plan;

    plan.form = kind_lines[s->kind];
    plan.du = s->span.dudx;
    plan.dv = s->span.dvdx;
    plan.chained = 0;
    cut_table(c, &plan, s->edges.lines, 0);
    draw_all(c, &s->span, kind_spans[s->kind]);
}

void cut_level(struct coverage *c, struct span_plan *span, int32 chained,
               void (*routine)(const struct span_plan *))
{
    struct parts_plan plan;

    plan.form = LINES_ADDX;
    plan.chained = chained;
    cut_table(c, &plan, (struct scanline *)span->lines, span->steps);
    draw_all(c, span, routine);
}
