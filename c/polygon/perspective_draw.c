/* Lines with perspective: by tables where they are good enough, exactly elsewhere. */
#include "polygon/perspective.h"

/* What each setting's lines are drawn by. */
static const struct {
    int32 piece, bend;
    int32 off, width;           /* as level lines: by so much at most, up to so wide */
} ways[PERSPECTIVE_KINDS] = {
    [PERSPECTIVE_EVERY16] = {PERSPECTIVE_PIECE_EVERY16, 0, 0, SCENE_SIDE_MAX},
    [PERSPECTIVE_EVERY8] = {PERSPECTIVE_PIECE_EVERY8, 0, 0, SCENE_SIDE_MAX},
    [PERSPECTIVE_PIXEL] = {PERSPECTIVE_PIECE_PIXEL, PERSPECTIVE_BEND_PIXEL,
                           PERSPECTIVE_LEVEL_PIXEL, SCENE_SIDE_MAX},
    [PERSPECTIVE_FINE] = {PERSPECTIVE_PIECE_FINE, PERSPECTIVE_BEND_FINE,
                          PERSPECTIVE_LEVEL_FINE, PERSPECTIVE_LEVEL_WIDTH}
};

/* K, u and v lie nearer than this to their bases: C then stays inside 64 bits. */
#define FAR (512 << 16)

static int32 is_near(fix16 value, fix16 low, fix16 high)
{
    return value > -FAR && value < FAR && low > -FAR && high < FAR;
}

static int32 find_constants(struct reciprocal_plan *plan)
{
    const struct perspective_plan *planes = plan->planes;
    int32 y = 0;

    while (planes->lines[y].last < planes->lines[y].left)
        if (++y == planes->count)
            return 0;
    if (!planes->gentle
        || !reciprocal_find(plan, planes->lines[y].left - EDGE_BIAS - planes->left, y)
        || !is_near(plan->ku, planes->u_low, planes->u_high)
        || !is_near(plan->kv, planes->v_low, planes->v_high))
        return 0;
    plan->ku += planes->u;
    plan->kv += planes->v;
    return 1;
}

/* Draws the lines it can and empties them; returns how many are left. So below. */
static int32 draw_reciprocals(struct perspective_plan *planes, const struct material *material,
                              const struct span_plan *span, int32 width)
{
    static struct reciprocal_line drawn[SCENE_SIDE_MAX];
    struct reciprocal_plan plan;
    struct reciprocal_span lines;
    int32 reach, left;

    plan.planes = planes;
    plan.piece = ways[material->perspective].piece;
    plan.table = material->reciprocals;
    plan.to = drawn;
    if (!find_constants(&plan))
        return planes->count;
    reach = plan.piece == PERSPECTIVE_PIECE_EVERY16 ? RECIPROCAL_REACH_16 : RECIPROCAL_REACH_8;
    plan.limit = (uint32)(reach - width / RECIPROCAL_REACH_WIDTH) << (24 - plan.piece);
    left = reciprocal_lines(&plan);
    lines.lines = drawn;
    lines.count = planes->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.table = plan.table;
    if (plan.piece == PERSPECTIVE_PIECE_EVERY16)
        span_reciprocal_16(&lines);
    else
        span_reciprocal_8(&lines);
    return left;
}

static int32 draw_logarithms(struct perspective_plan *planes,
                             const struct logarithm_tables *tables,
                             const struct span_plan *span)
{
    static struct logarithm_line drawn[SCENE_SIDE_MAX];
    struct reciprocal_plan plan;
    struct logarithm_span lines;
    int32 left;

    plan.planes = planes;
    if (!find_constants(&plan))
        return planes->count;
    left = logarithm_lines(&plan, tables, drawn);
    lines.lines = drawn;
    lines.count = planes->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.logs = tables->logs;
    lines.powers = tables->powers;
    span_logarithm(&lines);
    return left;
}

static void draw_exactly(struct perspective_plan *plan, enum perspective kind,
                         const struct span_plan *span)
{
    static struct perspective_line drawn[SCENE_SIDE_MAX];
    struct perspective_span lines;

    plan->bend = ways[kind].bend;
    plan->to = drawn;
    perspective_lines(plan);
    lines.lines = drawn;
    lines.count = plan->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.longest = ways[kind].piece;
    if (plan->bend)
        span_perspective_curves(&lines);
    else
        span_perspective_pieces(&lines);
}

/* Whether depth changes so little along lines that they may be drawn as if it did not. */
static int32 is_level(const struct perspective_plan *plan, int32 width, enum perspective kind)
{
    int32 tolerance = ways[kind].off;
    const struct number64 *grows = &plan->q.dx;
    uint32 part = grows->hi ? 0 - grows->lo : grows->lo;
    fix16 farthest = plan->u_high > plan->v_high ? plan->u_high : plan->v_high;
    int32 off;

    if ((grows->hi && grows->hi != 0xffffffff) || part >> 16 == 0xffff
        || width > ways[kind].width)
        return 0;
    if (!part)
        return !grows->hi;
    if (-plan->u_low > farthest)
        farthest = -plan->u_low;
    if (-plan->v_low > farthest)
        farthest = -plan->v_low;
    /* in units of q: what it grows by along the width, times texels */
    off = mul_shift(((farthest >> 16) + 1) * width, (int32)(part >> 16) + 1, 16) + 1;
    return off <= (plan->q_low >> 16) * tolerance + ((plan->q_low & 0xffff) * tolerance >> 16);
}

static void draw_level(const struct perspective_plan *plan, const struct span_plan *span)
{
    static struct scanline_step steps[SCENE_SIDE_MAX];
    struct span_plan lines;

    level_lines(plan, steps);
    lines.lines = plan->lines;
    lines.count = plan->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.steps = steps;
    span_affine_scanline(&lines);
}

void perspective_draw(struct perspective_plan *plan, const struct material *material,
                      const struct span_plan *span, int32 width, struct draw_counts *counts)
{
    enum perspective kind = material->perspective;
    uint32 pixels = counts ? lines_pixels(plan->lines, plan->count) : 0, others;
    int32 left = plan->count;

    if (is_level(plan, width, kind)) {
        draw_level(plan, span);
        if (counts) {
            counts->polygons++;
            counts->pixels[SPAN_AFFINE_SCANLINE] += pixels;
        }
        return;
    }
    if (material->reciprocals)
        left = draw_reciprocals(plan, material, span, width);
    else if (material->logarithms)
        left = draw_logarithms(plan, material->logarithms, span);
    if (counts) {
        others = left ? lines_pixels(plan->lines, plan->count) : 0;
        counts->polygons++;
        counts->pixels[material->reciprocals ? SPAN_RECIPROCAL : SPAN_LOGARITHM]
            += pixels - others;
        counts->pixels[kind == PERSPECTIVE_PIXEL || kind == PERSPECTIVE_FINE
                       ? SPAN_PERSPECTIVE_CURVES : SPAN_PERSPECTIVE_PIECES] += others;
    }
    if (left)
        draw_exactly(plan, kind, span);
}
