/* Lines are cut where they are hidden: a line's table entry becomes its first visible part, and its other
   parts are drawn after the table, those of neighbouring lines together. u and v of a part's first pixel are
   those that the span would step to, so that it has the same texels. */
#include "coverage/cut.h"

#include "polygon/kind.h"

/* How the start of a line is moved. */
struct move {
    enum line_form form;
    fix16 du, dv;               /* texels a pixel */
    int32 chained;
};

/* Returns how often v, 8.24 of 8.16, wraps in `pixels` steps: less than 0 if downwards. */
static int32 wraps(uint32 v, fix16 dv, int32 pixels)
{
    const int32 step = (int32)((uint32)dv << 8) >> 8;
    const int32 low = (int32)(v & 0xfff) + pixels * (step & 0xfff);

    return ((int32)(v >> 12 & 0xfff) + pixels * (step >> 12) + (low >> 12)) >> 12;
}

/* Moves the start of a line of the addx form. */
static void move_addx(struct scanline *line, const struct move *move, int32 pixels)
{
    uint32 u = (line->start2 & 0xff) << 16 | line->start0;
    uint32 v = (uint32)line->start1 << 8 | line->start2 >> 24;

    u += (uint32)pixels * (uint32)move->du;
    if (move->chained)
        u += (uint32)wraps(v, move->dv, pixels);
    v += (uint32)pixels * (uint32)move->dv;
    line->start0 = (uint16)u;
    line->start1 = (uint16)(v >> 8);
    line->start2 = v << 24 | (u >> 16 & 0xff);
}

static void move_plain(struct scanline *line, const struct move *move, int32 pixels)
{
    const uint32 u = ((uint32)line->start1 << 16 | line->start0) + (uint32)pixels * (uint32)move->du;

    line->start0 = (uint16)u;
    line->start1 = (uint16)(u >> 16);
    line->start2 += (uint32)pixels * (uint32)move->dv;
}

/* Makes a line its visible part. */
static void cut(struct scanline *line, const struct visible_part *part, const struct move *move)
{
    const int32 pixels = part->left - line->left;

    line->left = part->left;
    line->last = part->last;
    if (pixels <= 0 || part->last < part->left)
        return;
    if (move->form == LINES_ADDX)
        move_addx(line, move, pixels);
    else if (move->form == LINES_PLAIN)
        move_plain(line, move, pixels);
}

/* Cuts all lines of a table to the parts of the last scan. steps: of each line, or 0: all have those of
   `move`. */
static void cut_table(struct coverage *c, struct scanline *lines, struct move *move,
                      const struct scanline_step *steps)
{
    const struct visible_part *part = c->parts, *const end = c->parts_end;

    c->second.count = c->further.count = 0;
    while (part < end) {
        const struct visible_part *const first = part++;
        const uint16 row = first->row;
        struct scanline *const line = &lines[row];

        if (steps) {
            move->du = steps[row].dudx;
            move->dv = steps[row].dvdx;
        }
        for (struct cut_lines *to = &c->second; part < end && part->row == row; part++, to = &c->further) {
            struct scanline *const more = &to->lines[to->count];

            *more = *line;
            cut(more, part, move);
            if (steps)
                to->steps[to->count] = steps[row];
            to->rows[to->count++] = row;
        }
        cut(line, first, move);
    }
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
    struct move move;

    move.form = (enum line_form)kind_lines[s->kind];
    move.du = s->span.dudx;
    move.dv = s->span.dvdx;
    move.chained = 0;
    cut_table(c, s->edges.lines, &move, 0);
    draw_all(c, &s->span, kind_spans[s->kind]);
}

void cut_level(struct coverage *c, struct span_plan *plan, int32 chained,
               void (*routine)(const struct span_plan *))
{
    struct move move;

    move.form = LINES_ADDX;
    move.chained = chained;
    cut_table(c, (struct scanline *)plan->lines, &move, plan->steps);
    draw_all(c, plan, routine);
}
