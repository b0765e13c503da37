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

/* The last is for every8 where a tolerance has chosen it: it allows no more than 8 pixels. */
const struct far_lengths far_lengths[3] = {
    LENGTHS(FAR_EVERY16),
    LENGTHS(FAR_EVERY8),
    {0, 1 << (FAR_EVERY8 - 6), 1 << (FAR_EVERY8 - 4), 1 << (FAR_EVERY8 - 2)}
};

/* Returns the index of q, less FAR_ORIGIN, from which on q / step is 2^bits / 8 or more, so that pieces of
   16 pixels may be drawn if bits is FAR_EVERY16 - 21, and so on. */
static int16 first_index(uint32 step, int32 bits)
{
    const uint32 index = (step + (1u << bits) - 1) >> bits;

    return (int16)(index < 65536 ? (int32)index - FAR_ORIGIN : FAR_NEVER);
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
