/* Draws what of polygons is visible: whole ones as ever; affine lines, and those of constant depth, cut; others
   aside, in a frame of the same size, from which visible parts are copied. */
#include "coverage/coverage.h"
#include "coverage/cut.h"
#include "span/far.h"

#define DRAW_INSIDE_ONLY
#include "drawing/parts/perspective.c"

#include "drawing/draw.c"

/* Makes the table of a polygon's lines without u and v. */
static void make_outline(struct setup *s)
{
    outline_lines(s, EDGES_ARE_EXACT(s->material->edges) ? edge_flat_exact : edge_flat, scissor_flat);
}

/* Returns 1 if lines of the kind of span that the vertices ask for are cut. */
static int32 is_cut(const struct setup *s)
{
    if (s->form != FORM_ADDX || (s->material->gradients != GRADIENTS_PLANE && s->kind > SPAN_FILL_32))
        return 0;
    switch ((int)s->kind) {
    case SPAN_FILL:
    case SPAN_FILL_16:
    case SPAN_FILL_32:
    case SPAN_GOURAUD:
    case SPAN_AFFINE_ADDX_WRAP:
    case SPAN_AFFINE_16_WRAP:
    case SPAN_AFFINE_32_WRAP:
    case SPAN_ARBITRARY:
    case SPAN_LIT_WRAP:
        return 1;
    default:
        return 0;
    }
}

static void copy(uint8 *to, const uint8 *from, int32 bytes)
{
    for (; bytes >= 16; bytes -= 16) {
        const uint32 *four = (const uint32 *)from;
        uint32 *out = (uint32 *)to;

        *out++ = *four++;
        *out++ = *four++;
        *out++ = *four++;
        *out++ = *four++;
        from = (const uint8 *)four;
        to = (uint8 *)out;
    }
    for (; bytes >= 4; bytes -= 4, to += 4, from += 4)
        *(uint32 *)to = *(const uint32 *)from;
    for (; bytes > 0; bytes--)
        *to++ = *from++;
}

/* Copies the visible parts of lines that were drawn aside. whole: lines without parts too. */
static void copy_parts(const struct coverage *c, const struct setup *s, uint8 *row, int32 whole)
{
    const struct visible_part *part = c->parts;
    const struct scanline *line = s->edges.lines;
    const int32 bytes = s->frame->pixel_bytes;

    for (int32 i = 0; i < s->span.count; i++, line++, row += s->span.pitch) {
        if (part == c->parts_end || part->row != i) {
            if (whole && line->last >= line->left) {
                uint8 *to = row + line->left * bytes;

                copy(to, to + c->aside, (line->last + 1 - line->left) * bytes);
            }
            continue;
        }
        for (; part < c->parts_end && part->row == i; part++)
            if (part->last >= part->left) {
                uint8 *to = row + part->left * bytes;

                copy(to, to + c->aside, (part->last + 1 - part->left) * bytes);
            }
    }
}

/* Counts what the last scan found hidden. */
static void count_hidden(const struct coverage *c, struct setup *s)
{
    uint32 pixels = lines_pixels(s->edges.lines, s->span.count), hidden = 0;
    const struct visible_part *part = c->parts;

    while (part < c->parts_end) {
        const uint16 row = part->row;
        const struct scanline *line = &s->edges.lines[row];

        hidden += (uint32)(line->last + 1 - line->left);
        for (; part < c->parts_end && part->row == row; part++)
            if (part->last >= part->left)
                hidden -= (uint32)(part->last + 1 - part->left);
    }
    s->counts->hidden_pixels += hidden;
    if (hidden == pixels && pixels)
        s->counts->hidden++;
}

static void span(struct setup *s)
{
    struct coverage *const c = s->renderer->coverage;

    if (c->way == COVER_CUT)
        cut_span(c, s);
    else
        kind_spans[s->kind](&s->span);
}

static void level(const struct setup *s)
{
    struct coverage *const c = s->renderer->coverage;
    struct scanline_step *const steps = (struct scanline_step *)s->scratch->room;
    struct span_plan plan;
    span_routine *routine;

    if (c->way != COVER_ASIDE || light_kind(s)) {
        perspective_draw_level(s, steps);
        return;
    }
    routine = perspective_make_level(s, steps, &plan);
    if (!routine)
        return;
    c->way = COVER_CUT;
    plan.row -= c->aside;
    cut_level(c, &plan, s->perspective->chained, routine);
}

static void lines(const struct setup *s)
{
    const struct coverage *const c = s->renderer->coverage;

    if (c->way == COVER_DIRECT)
        return;
    for (const struct visible_part *part = c->parts; part < c->parts_end; part++)
        if (part->last < part->left)
            s->edges.lines[part->row].last = (int16)(s->edges.lines[part->row].left - 1);
}

/* Ends a line that is drawn from its far end where no pixel is visible behind. Returns 0 if it needs no copy: it is
   hidden whole, or visible from its far end on in one part, and is drawn in its place. */
static int32 place_cut(const struct coverage *c, struct far_line *to, const struct visible_part *first,
                       const struct visible_part *end, uint8 *row, int32 leftwards)
{
    int32 goes_on;

    if (first->last < first->left)
        return 0;
    if (leftwards) {
        to->end = row + first->left;
        goes_on = to->from == row + end[-1].last + 1;
    } else {
        to->end = row + end[-1].last + 1;
        goes_on = to->from == row + first->left;
    }
    if (end != first + 1 || !goes_on)
        return 1;
    to->from -= c->aside;
    to->end -= c->aside;
    return 0;
}

static void far(const struct setup *s, struct far_line *to, int32 leftwards, int32 cuts)
{
    struct coverage *const c = s->renderer->coverage;
    struct visible_part *part = c->parts, *kept = c->parts, *first;
    uint8 *row = s->span.row;

    if (c->way != COVER_ASIDE || light_kind(s))
        return;
    for (int32 i = 0; i < s->span.count; i++, to++, row += s->span.pitch) {
        if (part == c->parts_end || part->row != i) {
            to->from -= c->aside;
            to->end -= c->aside;
            continue;
        }
        first = kept;
        for (; part < c->parts_end && part->row == i; part++)
            *kept++ = *part;
        if (cuts && !place_cut(c, to, first, kept, row, leftwards))
            kept = first;
    }
    c->parts_end = kept;
    c->way = COVER_LINES_ASIDE;
}

static const struct cover hooks = {lines, span, level, far};

/* Copies what of a polygon was drawn aside; row: the first line's in the frame. */
static void copy_aside(const struct coverage *c, struct setup *s, uint8 *row)
{
    if (c->way == COVER_CUT)
        return;
    if (c->way == COVER_ASIDE)
        make_outline(s);        /* the table may have had other uses */
    copy_parts(c, s, row, c->way == COVER_ASIDE);
}

/* Draws what is visible of a polygon whose outline and span are set. */
static enum polygon_result draw_visible(struct setup *s)
{
    struct coverage *const c = s->renderer->coverage;
    struct scan_plan plan;
    enum polygon_result result;
    uint8 *const row = s->span.row;

    make_outline(s);
    plan.lines = s->edges.lines;
    plan.count = s->span.count;
    plan.rows = c->rows + s->box.top;
    plan.coverage = c;
    c->way = COVER_DIRECT;
    coverage_scan(&plan);
    if (s->counts) {
        count_hidden(c, s);
        if (s->renderer->only_counts)
            return draw_inside(s, &hooks);
    }
    if (c->overflow || !c->seen)
        return POLYGON_DRAWN;
    c->shown = 1;
    if (c->parts == c->parts_end)
        return draw_inside(s, &hooks);
    if (is_cut(s)) {
        c->way = COVER_CUT;
        return draw_inside(s, &hooks);
    }
    c->way = COVER_ASIDE;
    s->span.row += c->aside;
    result = draw_inside(s, &hooks);
    if (result == POLYGON_DRAWN)
        copy_aside(c, s, row);
    return result;
}

enum polygon_result cover_rest(struct deep *deep, int32 is_sure)
{
    struct setup *s = &deep->s;
    struct coverage *const c = s->renderer->coverage;
    uint8 *const row = s->span.row;
    enum polygon_result result = POLYGON_DRAWN;
    const int32 is_whole = c->parts == c->parts_end;

    if (!is_whole) {
        c->way = COVER_ASIDE;
        s->span.row += c->aside;
    }
    if (!is_sure || !draw_deep(s, &hooks, &deep->depth)) {
        s->kind = s->affine;
        plan_set_plane(s);
        result = draw_inside(s, &hooks);
        s->kind = SPAN_PERSPECTIVE;
    }
    if (!is_whole && result == POLYGON_DRAWN)
        copy_aside(c, s, row);
    return result;
}

/* Sets the plan for a material in this frame. Returns 0 if others draw its polygons. */
static int32 set_deep(struct coverage *c, struct renderer *renderer, const struct material *material)
{
    struct deep *const deep = &c->deep;

    if (!c->deep_is_set) {
        deep->s.material = 0;
        c->deep_is_set = deep_begin(deep, renderer) ? 1 : -1;
    }
    return c->deep_is_set > 0 && (deep->s.material == material || deep_take(deep, material));
}

enum polygon_result coverage_draw_met(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material)
{
    enum polygon_result result;
    struct setup s;

    if (!is_polygon(polygon))
        return POLYGON_FEW;
    if (is_fan(renderer, polygon, material))
        return polygon_fan(coverage_draw_met, renderer, polygon, material);
    if (material->perspective && set_deep(renderer->coverage, renderer, material)) {
        struct deep *const deep = &renderer->coverage->deep;
        int32 drawn;

        deep_set_vertices(deep, polygon);
        drawn = cover_draw(deep);
        if (drawn != DEEP_CONSTANT)
            return (enum polygon_result)drawn;
    }
    s.form = renderer->form;
    setup_begin(&s, renderer, polygon, material);
    result = plan_set_up(&s);
    return count_rules(&s, result == POLYGON_DRAWN ? draw_visible(&s) : result);
}

enum polygon_result coverage_draw(struct renderer *renderer, const struct polygon *polygon,
                                  const struct material *material)
{
    /* what is counted is counted with its pixels */
    if (!renderer->only_counts
        && coverage_hides(renderer->coverage, renderer->frame, polygon->vertices, polygon->count))
        return POLYGON_EMPTY;
    return coverage_draw_met(renderer, polygon, material);
}
