#include "perspective/far.h"

#include "span/far.h"

typedef void far_routine(const struct far_span *span);

static far_routine *const spans[2][2][2] = {    /* [even][coarse][q grows to the left] */
    {{span_far_right, span_far_left}, {span_far_right_coarse, span_far_left_coarse}},
    {{span_far_even_right, span_far_even_left},
     {span_far_even_right_coarse, span_far_even_left_coarse}}
};

static const struct far_lengths every16 = {
    1 << (FAR_EVERY16 - 8), 1 << (FAR_EVERY16 - 6), 1 << (FAR_EVERY16 - 4), FAR_MOST / 2
};
static const struct far_lengths every8 = {
    0, 1 << (FAR_EVERY8 - 6), 1 << (FAR_EVERY8 - 4), 1 << (FAR_EVERY8 - 2)
};

/* The upper half of a number times 2^bits; bits: 1 to 31. */
static int32 upper(const struct number64 *from, int32 bits)
{
    return (int32)(from->hi << bits | from->lo >> (32 - bits));
}

/* Returns log2 of the pixels that pieces of even spans have; 0 if they do not draw the polygon. least: of q. */
static int32 even_piece(const struct far_lengths *lengths, uint32 steep, int32 least)
{
    if (least < 1 << FAR_EVEN)
        return 0;
    steep <<= 1;
    return steep <= lengths->most_16 ? 4 : steep <= lengths->most_8 ? 3
         : steep <= lengths->most_4 ? 2 : 0;
}

int32 far_shift(const struct setup *s, int32 *lowest)
{
    const struct perspective_plan *planes = s->perspective;
    const uint8 edges = s->material->edges;
    const int32 steep = perspective_steepness(&planes->q.dx) + 1;
    /* steps are cut, and by rounded edges a pixel may be a step outside the polygon */
    const int32 least = planes->q_low - (planes->count + s->box.right - s->box.left)
                      - (edges == EDGES_EXACT || edges == EDGES_SNAPPED ? 0 : steep);
    int32 shift = 0;

    *lowest = least;
    if (least < 1 << (29 - FAR_DEEP) || planes->q_high > (1 << 30) + steep)
        return -1;
    while (!(least >> (29 - shift)))
        shift += 2;
    return steep > FAR_MOST >> shift ? -1 : shift;
}

/* Returns the whole texels from K to the farther end of a range, rounded up. */
static int32 farthest(fix16 k, fix16 low, fix16 high)
{
    const fix16 above = high - k, below = k - low;

    return ((above > below ? above : below) >> 16) + 1;
}

int32 far_draw(const struct setup *s, const struct reciprocal_plan *plan, int32 shift, int32 least,
               int32 longest)
{
    const struct perspective_plan *planes = plan->planes;
    const struct far_lengths *lengths = longest == 16 ? &every16 : &every8;
    const int32 even = even_piece(lengths, (uint32)fix_magnitude((int32)planes->q.dx.hi), least);
    const int32 up = even ? 1 : shift;
    const int32 leftwards = (int32)planes->q.dx.hi < 0;
    const int32 to_u = farthest(plan->ku, planes->u_low, planes->u_high);
    const int32 to_v = farthest(plan->kv, planes->v_low, planes->v_high);
    const int32 coarse = to_u > FAR_REACH || to_v > FAR_REACH;
    const int32 bits = coarse ? 8 - FAR_BITS - FAR_COARSE : 8 - FAR_BITS;
    const int32 down = planes->count << up;
    const int32 part = FAR_OFF_PART + ((((s->box.right - s->box.left) << up) + down) >> 11);
    const int32 off = FAR_OFF + (coarse ? down >> 1 : FAR_OFF_WORD + (down >> 5));
    struct far_span span;

    if (to_u > FAR_REACH << FAR_COARSE || to_v > FAR_REACH << FAR_COARSE)
        return 0;
    if (s->renderer->only_counts)
        return 1;
    span.lines = planes->lines;
    span.count = planes->count;
    span.row = s->span.row;
    span.pitch = s->span.pitch;
    span.map = s->span.map;
    span.table = s->renderer->reciprocals;
    span.dqdx = (int32)planes->q.dx.hi;
    span.dqdy = (int32)planes->q.dy.hi;
    span.q = planes->q.at.hi - (uint32)span.dqdx * (uint32)(planes->left + EDGE_BIAS);
    span.dq = (uint32)(leftwards ? -span.dqdx : span.dqdx);
    span.lengths = *lengths;
    span.even = even;
    span.ku = (uint32)(plan->ku + planes->u + off + (to_u * part >> 2)) << 8;
    span.kv = (uint32)(plan->kv + planes->v + off + (to_v * part >> 2)) << 8;
    span.dcu = (uint32)upper(&plan->dcu, bits);
    span.dcv = (uint32)upper(&plan->dcv, bits);
    span.cu = (uint32)upper(&plan->cu, bits);
    span.cv = (uint32)upper(&plan->cv, bits);
    spans[even != 0][coarse][leftwards](&span);
    return 1;
}

/* Returns the most texels of u or v from its base, rounded up. */
static int32 range(fix16 low, fix16 high)
{
    return ((-low > high ? -low : high) >> 16) + 1;
}

int32 far_draw_planes(const struct setup *s, int32 shift, int32 longest)
{
    const struct perspective_plan *planes = s->perspective;
    const int32 to_u = range(planes->u_low, planes->u_high);
    const int32 to_v = range(planes->v_low, planes->v_high);
    const int32 way = (planes->count + s->box.right - s->box.left) << shift;
    const int32 part = FAR_OFF_PART + (way >> 11), off = FAR_OFF_PLANES + (way >> 1);
    const uint32 bias = (uint32)(planes->left + EDGE_BIAS);
    struct far_planes_span span;

    span.dsdx = upper(&planes->s.dx, 32 - FAR_SCALE);
    span.dtdx = upper(&planes->t.dx, 32 - FAR_SCALE);
    if (to_u > FAR_RANGE || to_v > FAR_RANGE || way > FAR_WAY
        || fix_magnitude(span.dsdx) > (uint32)FAR_STEP >> shift
        || fix_magnitude(span.dtdx) > (uint32)FAR_STEP >> shift)
        return 0;
    if (s->renderer->only_counts)
        return 1;
    span.lines = planes->lines;
    span.count = planes->count;
    span.row = s->span.row;
    span.pitch = s->span.pitch;
    span.map = s->span.map;
    span.table = s->renderer->reciprocals;
    span.dqdx = (int32)planes->q.dx.hi;
    span.dqdy = (int32)planes->q.dy.hi;
    span.q = planes->q.at.hi - (uint32)span.dqdx * bias;
    span.dsdy = upper(&planes->s.dy, 32 - FAR_SCALE);
    span.s = (int32)((uint32)upper(&planes->s.at, 32 - FAR_SCALE) - (uint32)span.dsdx * bias);
    span.dtdy = upper(&planes->t.dy, 32 - FAR_SCALE);
    span.t = (int32)((uint32)upper(&planes->t.at, 32 - FAR_SCALE) - (uint32)span.dtdx * bias);
    span.u = planes->u + off + (to_u * part >> 2);
    span.v = planes->v + off + (to_v * part >> 2);
    span.lengths = longest == 16 ? every16 : every8;
    if (span.dqdx < 0)
        span_far_planes_left(&span);
    else
        span_far_planes_right(&span);
    return 1;
}
