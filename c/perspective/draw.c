/* Draws lines with perspective: by tables if they are accurate enough, otherwise exactly. */
#include "perspective/far.h"
#include "perspective/light.h"
#include "span/far.h"
#include "polygon/counts.h"
#include "polygon/kind.h"

/* How each setting's lines are drawn. */
static const struct {
    int32 piece, bend;
    int32 raise;                /* units, of u and v */
    int32 off, width;           /* level lines: error allowed, widest polygon */
} ways[PERSPECTIVE_KINDS] = {
    [PERSPECTIVE_EVERY16] = {PERSPECTIVE_PIECE_EVERY16, 0, PERSPECTIVE_RAISE_EVERY16, 0,
                             FRAME_SIDE_MAX},
    [PERSPECTIVE_EVERY8] = {PERSPECTIVE_PIECE_EVERY8, 0, PERSPECTIVE_RAISE_EVERY8, 0,
                            FRAME_SIDE_MAX},
    [PERSPECTIVE_PIXEL] = {PERSPECTIVE_PIECE_PIXEL, PERSPECTIVE_BEND_PIXEL,
                           PERSPECTIVE_RAISE_PIXEL, PERSPECTIVE_LEVEL_PIXEL, FRAME_SIDE_MAX},
    [PERSPECTIVE_FINE] = {PERSPECTIVE_PIECE_FINE, PERSPECTIVE_BEND_FINE,
                          PERSPECTIVE_RAISE_FINE, PERSPECTIVE_LEVEL_FINE,
                          PERSPECTIVE_LEVEL_WIDTH}
};

/* All lines in the form that a span reads, prepared before they are drawn; one form at a time. */
union made {
    struct logarithm_line logarithms[FRAME_SIDE_MAX];
    struct perspective_line exact[FRAME_SIDE_MAX];
    struct scanline_step steps[FRAME_SIDE_MAX];
};

SCRATCH_FITS(union made);

/* K, u and v are nearer than this to their bases, so that C fits 64 bits with 6 bits, or with 3. */
#define FAR_512 (512 << 16)
#define FAR_4096 (4096 << 16)

/* Returns 1 if K (value) and the range are nearer than `far` to the base, and K is at most reach
   outside the range: some line may then be within reach of K. */
static int32 is_near(fix16 value, fix16 low, fix16 high, fix16 reach, fix16 far)
{
    return value > -far && value < far && low > -far && high < far
        && low - value <= reach && value - high <= reach;
}

/* Finds K and C. Returns 0 if no line can be drawn with them. reach: texels from K, 16.16, beyond
   which lines are not drawn. */
static int32 find_constants(struct reciprocal_plan *plan, fix16 reach, int32 bits)
{
    const struct perspective_plan *planes = plan->planes;
    const fix16 far = bits == FAR_BITS ? FAR_4096 : FAR_512;
    int32 y = 0;

    plan->bits = bits;

    while (planes->lines[y].last < planes->lines[y].left)
        if (++y == planes->count)
            return 0;
    return planes->gentle
        && reciprocal_find(plan, planes->lines[y].left - EDGE_BIAS - planes->left, y)
        && is_near(plan->ku, planes->u_low, planes->u_high, reach, far)
        && is_near(plan->kv, planes->v_low, planes->v_high, reach, far);
}

static int32 is_drawn_from_afar(const struct setup *s)
{
    struct reciprocal_plan plan;
    const int32 shift = far_shift(s);

    plan.planes = s->perspective;
    return shift >= 0
        && ((find_constants(&plan, FAR_4096, FAR_BITS)
             && far_draw(s, &plan, shift, 1 << ways[s->setting].piece))
            || far_draw_planes(s, shift, 1 << ways[s->setting].piece));
}

/* Draws the lines it can and empties them; returns how many are left. */
static int32 draw_logarithms(const struct setup *s, union made *made)
{
    const struct logarithm_tables *tables = s->renderer->logarithms;
    struct perspective_plan *planes = s->perspective;
    const struct span_plan *span = &s->span;
    struct reciprocal_plan plan;
    struct logarithm_span lines;
    int32 left;

    plan.planes = planes;
    if (!find_constants(&plan, FAR_512, RECIPROCAL_BITS))
        return planes->count;
    plan.ku += planes->u + LOGARITHM_OFF;
    plan.kv += planes->v + LOGARITHM_OFF;
    left = logarithm_lines(&plan, tables, made->logarithms);
    if (s->renderer->only_counts)
        return left;
    lines.lines = made->logarithms;
    lines.count = planes->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.logs = tables->logs;
    lines.powers = tables->powers;
    span_logarithm(&lines);
    return left;
}

/* Raises the plan's u and v. */
static void draw_exactly(const struct setup *s, union made *made)
{
    struct perspective_plan *plan = s->perspective;
    const struct span_plan *span = &s->span;
    struct perspective_span lines;

    plan->u += ways[s->setting].raise;
    plan->v += ways[s->setting].raise;
    plan->bend = ways[s->setting].bend;
    plan->to = made->exact;
    perspective_lines(plan);
    lines.lines = made->exact;
    lines.count = plan->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.longest = ways[s->setting].piece;
    if (plan->bend)
        span_perspective_curves(&lines);
    else
        span_perspective_pieces(&lines);
}

static void draw_level(const struct setup *s, union made *made, int32 tilt)
{
    struct perspective_plan *plan = s->perspective;
    const struct span_plan *span = &s->span;
    struct span_plan lines;

    plan->tilt = tilt;
    level_lines(plan, made->steps);
    lines.lines = plan->lines;
    lines.count = plan->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.steps = made->steps;
    span_affine_scanline(&lines);
}

/* Counts the lines that tables drew, and those `left`. */
static void count(const struct setup *s, int32 left)
{
    const int32 pieces = ways[s->setting].bend == 0;
    const struct perspective_plan *plan = s->perspective;
    const uint32 others = left ? lines_pixels(plan->lines, plan->count) : 0;

    s->counts->pixels[pieces ? SPAN_RECIPROCAL : SPAN_LOGARITHM] -= others;
    s->counts->pixels[pieces ? SPAN_PERSPECTIVE_PIECES : SPAN_PERSPECTIVE_CURVES] += others;
}

/* Keeps the last pixels of lines, which logarithm_lines has emptied as it made `taken`, in start1, which
   flat lines do not use. */
static void keep_lines(const struct perspective_plan *plan, const struct logarithm_line *taken)
{
    struct scanline *line = plan->lines;

    for (int32 i = plan->count; i > 0; i--, line++, taken++)
        line->start1 = (uint16)(taken->n < 0 ? line->last : line->left + taken->n);
}

static void restore_lines(const struct perspective_plan *plan)
{
    struct scanline *line = plan->lines;

    for (int32 i = plan->count; i > 0; i--, line++)
        line->last = (int16)line->start1;
}

void perspective_draw(struct setup *s)
{
    union made *made = (union made *)s->scratch->room;
    struct perspective_plan *plan = s->perspective;
    enum perspective setting = s->setting;
    const int32 width = s->box.right - s->box.left, pieces = ways[setting].bend == 0;
    const int32 is_level = s->straight || (width <= ways[setting].width
                                           && perspective_is_level(plan, width, ways[setting].off));
    int32 left = plan->count, are_kept;

    /* what a tolerance allows is less than what a setting allows */
    if (is_level || (pieces && setting == s->material->perspective
                     && perspective_is_straight(plan, width))) {
        if (s->counts)
            count_lines(s, SPAN_AFFINE_SCANLINE);
        if (!s->renderer->only_counts)
            draw_level(s, made, is_level ? 0 : (int32)(plan->q.dx.hi << 16 | plan->q.dx.lo >> 16));
        return;
    }
    if (s->counts)              /* before lines that are drawn become empty */
        count_lines(s, pieces ? SPAN_RECIPROCAL : SPAN_LOGARITHM);
    if (pieces && s->renderer->reciprocals)
        left = is_drawn_from_afar(s) ? 0 : plan->count;
    else if (setting == PERSPECTIVE_PIXEL && s->renderer->logarithms)
        left = draw_logarithms(s, made);
    if (s->counts)
        count(s, left);
    are_kept = left && left < plan->count && light_kind(s);
    if (are_kept)
        keep_lines(plan, made->logarithms);
    if (left && !s->renderer->only_counts)
        draw_exactly(s, made);
    if (are_kept)
        restore_lines(plan);
}
