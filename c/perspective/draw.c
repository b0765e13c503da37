/* Draws lines with perspective: level ones, from the far end, or exactly. */
#include "perspective/light.h"
#include "perspective/perspective.h"
#include "perspective/tolerance.h"
#include "polygon/counts.h"
#include "polygon/kind.h"

/* How each setting's lines are drawn. */
static const struct {
    int32 piece, bend;
    int32 raise;                /* units, of u and v */
    int32 off, width;           /* level lines: error allowed, widest polygon */
    int32 saved;                /* cycles by columns, a pixel */
    int32 chain;                /* level lines: widest polygon with a chain of u and v */
    int32 spare;                /* level lines by reciprocals: units that their steps may add */
    int32 straight;             /* curves: units that straight pieces may be off */
    int32 even;                 /* straight pieces: log2 of the parts of a texel that level lines may be off */
} ways[PERSPECTIVE_KINDS] = {
    [PERSPECTIVE_EVERY16] = {PERSPECTIVE_PIECE_EVERY16, 0, PERSPECTIVE_RAISE_EVERY16, 0,
                             FRAME_SIDE_MAX, PERSPECTIVE_SAVED_EVERY16, FRAME_SIDE_MAX,
                             PERSPECTIVE_SPARE_PIECES, 0, PERSPECTIVE_EVEN_EVERY16},
    [PERSPECTIVE_EVERY8] = {PERSPECTIVE_PIECE_EVERY8, 0, PERSPECTIVE_RAISE_EVERY8, 0,
                            FRAME_SIDE_MAX, PERSPECTIVE_SAVED_EVERY8, FRAME_SIDE_MAX,
                            PERSPECTIVE_SPARE_PIECES, 0, PERSPECTIVE_EVEN_EVERY8},
    [PERSPECTIVE_PIXEL] = {PERSPECTIVE_PIECE_PIXEL, PERSPECTIVE_BEND_PIXEL,
                           PERSPECTIVE_RAISE_PIXEL, PERSPECTIVE_LEVEL_PIXEL, FRAME_SIDE_MAX,
                           PERSPECTIVE_SAVED_PIXEL, PERSPECTIVE_CHAIN_PIXEL,
                           PERSPECTIVE_SPARE_PIXEL, PERSPECTIVE_STRAIGHT_PIXEL},
    [PERSPECTIVE_FINE] = {PERSPECTIVE_PIECE_FINE, PERSPECTIVE_BEND_FINE,
                          PERSPECTIVE_RAISE_FINE, PERSPECTIVE_LEVEL_FINE,
                          PERSPECTIVE_LEVEL_WIDTH, PERSPECTIVE_SAVED_FINE, 0, PERSPECTIVE_SPARE_FINE,
                          PERSPECTIVE_STRAIGHT_FINE}
};

/* Tables of lines, and columns, are for texels of one byte. */
static int32 is_narrow(const struct setup *s)
{
    return s->frame->pixel_bytes == 1;
}

/* All lines in the form that a span reads, prepared before they are drawn; one form at a time. */
union made {
    struct perspective_line exact[FRAME_SIDE_MAX];
    struct scanline_step steps[FRAME_SIDE_MAX];
};

SCRATCH_FITS_LINE(struct perspective_line);

#define STEEP_2_22 (1 << 22)

/* Returns log2 of the pixels of straight pieces that are drawn exactly: as many, 64 at most, as keep the error of the
   setting's name, h^2 / (4 L) pixels, L = q / its growth, or a curve's tolerance; 0 if curves are needed. */
static int32 exact_piece(const struct setup *s)
{
    const struct perspective_plan *plan = s->perspective;
    const int32 steep = perspective_steepness(&plan->q.dx) + 1;
    const int32 half = s->setting == PERSPECTIVE_EVERY8;        /* a pixel, or half of one */
    int32 piece = ways[s->setting].piece;

    if (ways[s->setting].bend)
        return tolerance_straight(plan, ways[s->setting].straight);
    /* what a tolerance allows is less than what a setting allows */
    if (perspective_has_pieces(s->setting) && s->setting == (enum perspective)s->material->perspective)
        while (piece < PERSPECTIVE_PIECE_EXACT && steep <= plan->q_low / ((1 << (2 * piece + half)) + 1))
            piece++;
    return piece;
}

/* Raises the plan's u and v. piece: of exact_piece. */
static void draw_exactly(const struct setup *s, union made *made, int32 piece)
{
    const int32 raise = piece ? (2 << piece) + 2 : ways[s->setting].raise;
    struct perspective_plan *plan = s->perspective;
    const struct span_plan *span = &s->span;
    struct perspective_span lines;

    plan->u += raise;
    plan->v += raise;
    plan->bend = piece ? 0 : ways[s->setting].bend;
    plan->to = made->exact;
    perspective_lines(plan);
    lines.lines = made->exact;
    lines.count = plan->count;
    lines.row = span->row;
    lines.pitch = span->pitch;
    lines.map = span->map;
    lines.longest = piece ? piece : ways[s->setting].piece;
    (plan->bend ? perspective_curves : perspective_pieces)[s->frame->pixel_bytes >> 1](&lines);
}

/* Returns 1 unless q is the same everywhere: the picture is the affine one then. */
static int32 changes(const struct perspective_plan *plan)
{
    return (plan->q.dx.hi | plan->q.dx.lo | plan->q.dy.hi | plan->q.dy.lo) != 0;
}

/* Prepares lines without a tilt for a reciprocal each. Returns 0 if they are made without. Their first pixels are not
   clamped: edges must be exact. */
static int32 by_reciprocals(const struct setup *s)
{
    struct perspective_plan *plan = s->perspective;

    if (plan->tilt || plan->count < PERSPECTIVE_RECIPROCAL_LINES || !EDGES_ARE_EXACT(s->material->edges))
        return 0;
    plan->width = s->box.right - s->box.left;
    plan->spare = ways[s->setting].spare - (plan->width << plan->chained);
    return 1;
}

/* Counts lines of s->level, and sets what they have in common. Returns 0 if they are only counted. */
static int32 begin_level(const struct setup *s)
{
    struct perspective_plan *plan = s->perspective;

    if (s->counts)
        count_lines(s, s->level == LEVEL_LINES ? SPAN_AFFINE_SCANLINE : SPAN_AFFINE_UPRIGHT);
    if (s->renderer->only_counts)
        return 0;
    if (s->level == LEVEL_COLUMNS) {    /* as lines would be: for vertices whose depth is rounded */
        plan->u += ways[s->setting].raise;
        plan->v += ways[s->setting].raise;
    }
    plan->chained = changes(plan) && s->box.right - s->box.left <= ways[s->setting].chain;
    return 1;
}

/* Sets a plan of the lines that are made. Returns the routine that draws it. */
static span_routine *plan_level(const struct setup *s, const struct scanline_step *steps, struct span_plan *lines)
{
    const struct perspective_plan *plan = s->perspective;

    lines->lines = plan->lines;
    lines->count = plan->count;
    lines->row = s->span.row;
    lines->pitch = s->span.pitch;
    lines->map = s->span.map;
    lines->steps = steps;
    if (s->level == LEVEL_LINES)
        return perspective_scanlines[plan->chained][s->frame->pixel_bytes >> 1];
    return plan->chained ? span_affine_level_upright : span_affine_upright;
}

span_routine *perspective_make_level(const struct setup *s, struct scanline_step *steps, struct span_plan *lines)
{
    struct perspective_plan *plan = s->perspective;

    if (!begin_level(s))
        return 0;
    if (!by_reciprocals(s) || !level_reciprocal(plan, steps))
        level_lines(plan, steps);
    return plan_level(s, steps, lines);
}

void perspective_draw_level(const struct setup *s, struct scanline_step *steps)
{
    struct perspective_plan *plan = s->perspective;
    struct span_plan lines;

    if (!begin_level(s))
        return;
    if (by_reciprocals(s)) {
        if (plan->chained && is_narrow(s)) {
            plan->row = s->span.row;
            plan->pitch = s->span.pitch;
            plan->map = s->span.map;
            if ((s->level == LEVEL_LINES ? level_draw : level_draw_upright)(plan))
                return;
        } else if (level_reciprocal(plan, steps)) {
            plan_level(s, steps, &lines)(&lines);
            return;
        }
    }
    level_lines(plan, steps);
    plan_level(s, steps, &lines)(&lines);
}

/* Returns 1 if lines of so many pixels, on which q grows so, may be drawn as if their depth were constant: they
   are off by `off` at most. */
static int32 is_level(const struct setup *s, const struct number64 *grows, int32 width, int32 off)
{
    return grows->hi + 1 <= 1 && width <= ways[s->setting].width
        && perspective_is_level(s->perspective, grows, width, off);
}

/* What lines of so many pixels, on which q grows by `grows` a pixel, may be. */
enum shape { SHAPE_BENT, SHAPE_STRAIGHT, SHAPE_LEVEL };

/* Returns non-zero if the setting has straight pieces; what a tolerance allows is less than what a setting allows. */
static inline int32 may_be_straight(const struct setup *s)
{
    return !ways[s->setting].bend && s->setting == (enum perspective)s->material->perspective;
}

/* Returns the shape of lines of `width` pixels at most. off: as is_level's. SHAPE_STRAIGHT, from their first pixels
   to their last, if the chord of a line on which q is `least` or more is off by at most half a pixel's texels:
   width^2 / (4 L), L = q / |dq/dx|. SHAPE_LEVEL without that: depth hardly changes, so that a half or a quarter of
   a texel is all they are off. */
static int32 shape_of(const struct setup *s, const struct number64 *grows, int32 width, int32 off, int32 least)
{
    const struct perspective_plan *plan = s->perspective;
    const int32 steep = perspective_steepness(grows) + 1;

    if (is_level(s, grows, width, off))
        return SHAPE_LEVEL;
    if (steep >= STEEP_2_22 || !may_be_straight(s))
        return SHAPE_BENT;
    if (steep <= plan->q_low >> PERSPECTIVE_EVEN_STEEP && EDGES_ARE_EXACT(s->material->edges)
        && steep <= (plan->q_low >> ways[s->setting].even) / (((perspective_reach(plan) >> 16) + 1) * width))
        return SHAPE_LEVEL;
    return steep > least / ((width * width >> 1) + 1) ? SHAPE_BENT : SHAPE_STRAIGHT;
}

/* Sets the tilt of straight lines. */
static void set_tilt(struct perspective_plan *plan, const struct number64 *grows)
{
    plan->tilt = (int32)(grows->hi << 8 | grows->lo >> 24);
}

/* Returns 1 if columns of a shape are cheaper than lines. Of the box, a half of a triangle's is filled, of others'
   three quarters or so. */
static int32 columns_are_cheaper(const struct setup *s, int32 shape, int32 width, int32 height)
{
    const int32 quarters = s->count == 3 ? 2 : 3;
    const int32 column = shape == SHAPE_STRAIGHT ? PERSPECTIVE_COLUMN_TILTED : PERSPECTIVE_COLUMN;

    return PERSPECTIVE_TURN + width * (column - (ways[s->setting].saved * height * quarters >> 2))
         < PERSPECTIVE_LINE * height;
}

/* Finds whether columns are level or straight, and sets the plan's tilt and steep if so. */
static inline int32 has_columns(struct setup *s, int32 width, int32 height)
{
    struct perspective_plan *plan = s->perspective;
    const int32 shape = shape_of(s, &plan->q.dy, height, 0, PERSPECTIVE_ONE);

    if (!shape || !columns_are_cheaper(s, shape, width, height))
        return 0;
    if (shape == SHAPE_STRAIGHT) {
        set_tilt(plan, &plan->q.dy);
        /* a wall is highest where it is nearest: each column is tested */
        plan->steep = perspective_steepness(&plan->q.dy) + 1;
    }
    return 1;
}

void perspective_find_level(struct setup *s)
{
    struct perspective_plan *plan = s->perspective;
    const int32 width = s->box.right - s->box.left, height = s->box.bottom - s->box.top;
    int32 shape;

    plan->tilt = plan->steep = 0;
    if (s->level)
        return;
    shape = shape_of(s, &plan->q.dx, width, ways[s->setting].off, plan->q_low);
    if (shape) {
        s->level = LEVEL_LINES;
        if (shape == SHAPE_STRAIGHT)
            set_tilt(plan, &plan->q.dx);
    } else if (is_narrow(s) && EDGES_ARE_EXACT(s->material->edges) && has_columns(s, width, height)) {
        s->level = LEVEL_COLUMNS;
    }
}

void perspective_draw(struct setup *s)
{
    union made *made = (union made *)s->scratch->room;
    int32 piece;

    if (s->level == LEVEL_LINES) {
        perspective_draw_level(s, made->steps);
        return;
    }
    piece = exact_piece(s);
    if (s->counts)
        count_lines(s, piece ? SPAN_PERSPECTIVE_PIECES : SPAN_PERSPECTIVE_CURVES);
    if (!s->renderer->only_counts)
        draw_exactly(s, made, piece);
}
