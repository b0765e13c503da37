#include "perspective/far.h"

#include "span/far.h"

typedef void far_routine(const struct far_span *span);

static far_routine *const spans[2][3][2] = {    /* [even][coarse][q grows to the left] */
    {{span_far_right, span_far_left},
     {span_far_right_coarse, span_far_left_coarse},
     {span_far_right_coarser, span_far_left_coarser}},
    {{span_far_even_right, span_far_even_left},
     {span_far_even_right_coarse, span_far_even_left_coarse},
     {span_far_even_right_coarser, span_far_even_left_coarser}}
};

/* By log2 of the greatest step, of q 2^31, in pieces of one pixel. */
#define LENGTHS(every) \
    {1 << ((every) - 8), 1 << ((every) - 6), 1 << ((every) - 4), 1 << ((every) - 2)}

static const struct far_lengths every16 = LENGTHS(FAR_EVERY16);
static const struct far_lengths every8 = LENGTHS(FAR_EVERY8);
/* Where a tolerance has chosen every8, it allows no more than 8 pixels. */
static const struct far_lengths at_most_8 = {
    0, 1 << (FAR_EVERY8 - 6), 1 << (FAR_EVERY8 - 4), 1 << (FAR_EVERY8 - 2)};

/* Returns the index of q, less FAR_ORIGIN, from which on q / step is 2^bits / 8 or more, so that pieces of
   16 pixels may be drawn if bits is FAR_EVERY16 - 21, and so on. */
static int16 first_index(uint32 step, int32 bits)
{
    const uint32 index = (step + (1u << bits) - 1) >> bits;

    return (int16)(index < 65536 ? (int32)index - FAR_ORIGIN : FAR_NEVER);
}

/* Returns the bits by which q, at least `least`, has to be shifted left; -1 if its steps are too great for that. */
static int32 find_shift(int32 least, int32 steep)
{
    int32 shift = 0;

    while (!(least >> (29 - shift)))
        shift += 2;
    return steep > FAR_MOST >> shift ? -1 : shift;
}

/* Returns the lengths of pieces. */
static const struct far_lengths *lengths_of(const struct setup *s)
{
    return s->setting == PERSPECTIVE_EVERY16 ? &every16
         : s->material->perspective == PERSPECTIVE_EVERY8 ? &every8 : &at_most_8;
}

/* Finds K and C. pixels: the box's, across and down. Returns 0 if they do not fit. */
static int32 find_constants(struct far_way *way, const struct setup *s, const struct depth *depth,
                            int32 pixels)
{
    const struct perspective_plan *planes = s->perspective;
    const uint32 dq = fix_magnitude((int32)planes->q.dx.hi);
    struct far_plan *plan = &way->plan;
    int32 reach;

    way->part = FAR_OFF_PART + (((pixels + depth->off + FAR_OFF_CORNERS) << way->shift) >> 11);
    far_begin_plan(plan, depth);
    reach = far_find_reach(way, planes, FAR_REACH << FAR_COARSE);
    way->coarse = plan->less ? 2 : reach > FAR_REACH;
    if (plan->less && (!reach || reach > FAR_REACH << 2 * FAR_COARSE || dq < (uint32)way->part << 14))
        return 0;
    return far_find_c(plan, s, way->coarse ? FAR_BITS_COARSE : FAR_BITS);
}

int32 far_find(struct far_way *way, const struct setup *s, const struct depth *depth)
{
    const struct perspective_plan *planes = s->perspective;
    const uint32 dq = fix_magnitude((int32)planes->q.dx.hi);
    const int32 least = far_least(s, depth);

    if (!least)
        return 0;
    way->lengths = lengths_of(s);
    way->even = least >= 1 << FAR_EVEN && 2 * dq <= way->lengths->most_4;
    way->shift = way->even ? 1 : find_shift(least, perspective_steepness(&planes->q.dx) + 1);
    return way->shift >= 0
        && find_constants(way, s, depth, s->box.right - s->box.left + s->span.count);
}

struct far_line *far_make_lines(const struct setup *s, uint32 q, int32 dqdx, int32 dqdy, int32 has_lines)
{
    const int32 leftwards = dqdx < 0;
    union {
        struct far_place place;     /* both begin with it */
        struct far_lines lines;
        struct far_edges edges;
    } to;

    to.place.lines = (struct far_line *)s->scratch->room;
    to.place.row = s->span.row;
    to.place.pitch = s->span.pitch;
    to.place.q = q - (uint32)dqdx * (uint32)(s->perspective->left + EDGE_BIAS + leftwards);
    to.place.dqdx = dqdx;
    to.place.dqdy = dqdy;
    if (has_lines) {
        to.lines.from = s->edges.lines;
        to.lines.count = s->span.count;
        to.lines.leftwards = leftwards;
        lines_far(&to.lines);
    } else if (leftwards) {
        to.edges.far = s->edges.right;
        to.edges.near = s->edges.left;
        to.edges.fars = s->edges.rights;
        to.edges.nears = s->edges.lefts;
        edges_far(&to.edges);
    } else {
        to.edges.far = s->edges.left;
        to.edges.near = s->edges.right;
        to.edges.fars = s->edges.lefts;
        to.edges.nears = s->edges.rights;
        edges_far(&to.edges);
    }
    return to.place.lines;
}

/* Returns the entries by which the table for the ends of pieces is on; see FAR_AHEAD16. from_16: as a far_span's; bits:
   FAR_EVERY16 or so. */
static uint32 find_ahead(const struct setup *s, uint32 dq, int32 from_16, int32 bits)
{
    const uint32 least = (uint32)s->perspective->q_low, part = dq >> 9;
    const uint32 eighths = bits == FAR_EVERY16 ? FAR_AHEAD16 : FAR_AHEAD8;

    if (from_16 <= (int32)(least >> 15) - FAR_ORIGIN)   /* all have 16: 16^2 dq / (4 least) pixels */
        return (eighths * part * part >> 2) / (least >> 8);
    return eighths * dq >> (FAR_EVERY16 + 18 - bits);
}

void far_draw(const struct setup *s, const struct depth *depth, const struct far_way *way,
              const struct far_line *lines)
{
    const struct perspective_plan *planes = s->perspective;
    const struct far_plan *plan = &way->plan;
    const int32 leftwards = (int32)planes->q.dx.hi < 0;
    const int32 down = (depth->down + FAR_OFF_LINES) << way->shift;
    const int32 off = FAR_OFF + ((1 << way->shift) << plan->less)
                    + (way->coarse ? (down >> 1) << plan->less : FAR_OFF_WORD + (down >> 5));
    const int32 bits = s->setting == PERSPECTIVE_EVERY16 ? FAR_EVERY16 : FAR_EVERY8;
    struct far_span span;

    span.lines = lines;
    span.count = s->span.count;
    span.map = s->span.map;
    span.table = s->renderer->reciprocals;
    span.dq = (uint32)fix_magnitude((int32)planes->q.dx.hi);
    span.lengths = way->lengths;
    span.from_8 = first_index(2 * span.dq, bits - 19);
    span.from_16 = FAR_NEVER;
    span.ends = span.table;
    if (way->lengths->most_16) {         /* not if a tolerance allows 8 pixels */
        span.from_16 = first_index(2 * span.dq, bits - 21);
        if (way->even)
            span.ends += find_ahead(s, span.dq, span.from_16, bits);
    }
    span.ku = ((uint32)plan->ku << (8 - FAR_K_BITS + plan->less))
            + ((uint32)(planes->u + off + (way->to_u * way->part >> 2)) << 8);
    span.kv = ((uint32)plan->kv << (8 - FAR_K_BITS + plan->less))
            + ((uint32)(planes->v + off + (way->to_v * way->part >> 2)) << 8);
    span.dcu = plan->dcu;
    span.dcv = plan->dcv;
    span.cu = plan->cu;
    span.cv = plan->cv;
    spans[way->even][way->coarse][leftwards](&span);
}
