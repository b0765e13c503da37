#include "perspective/far.h"

#include "span/far.h"

typedef void far_routine(const struct far_span *span);

static far_routine *const spans[2][2][2] = {    /* [pieces of 16][coarse][q grows to the left] */
    {{span_far_8_right, span_far_8_left}, {span_far_8_right_coarse, span_far_8_left_coarse}},
    {{span_far_16_right, span_far_16_left}, {span_far_16_right_coarse, span_far_16_left_coarse}}
};

/* The upper half of a number times 2^bits; bits: 1 to 31. */
static int32 upper(const struct number64 *from, int32 bits)
{
    return (int32)(from->hi << bits | from->lo >> (32 - bits));
}

static uint32 swapped(int32 x)
{
    return (uint32)x << 16 | (uint32)x >> 16;
}

int32 far_piece(const struct perspective_plan *planes, int32 piece)
{
    const int32 steep = perspective_steepness(&planes->q.dx) + 1;

    if (steep >= FAR_STEEP || (planes->q_low - steep) >> 15 <= FAR_LOWEST
        || planes->q_high > (1 << 30) + steep)
        return 0;
    return planes->q_low / FAR_PIECES_8 < steep ? 3 : piece;
}

/* Returns 1 if C times 2^bits is below 2^31 on all lines. */
static int32 fits(const struct number64 *c, const struct number64 *dc, int32 count, int32 bits)
{
    return !(perspective_steepness(c) >> (30 - bits))
        && perspective_steepness(dc) < (1 << (29 - bits)) / count;
}

static int32 both_fit(const struct reciprocal_plan *plan, int32 bits)
{
    const int32 count = plan->planes->count;

    return fits(&plan->cu, &plan->dcu, count, bits) && fits(&plan->cv, &plan->dcv, count, bits);
}

/* Returns K in 8.24, raised by the most that starts may fall short: FAR_OFF_PART quarters of a unit for each
   texel from it, and `off` units. */
static uint32 raised(fix16 k, fix16 base, fix16 low, fix16 high, int32 off)
{
    const fix16 above = high - k, below = k - low;
    const int32 farthest = ((above > below ? above : below) >> 16) + 1;

    return (uint32)(k + base + off + (farthest * FAR_OFF_PART >> 2)) << 8;
}

int32 far_draw(const struct setup *s, const struct reciprocal_plan *plan, int32 piece)
{
    const struct perspective_plan *planes = plan->planes;
    const int32 dqdx = upper(&planes->q.dx, 1), leftwards = dqdx < 0;
    const int32 fine = 13 - FAR_BITS - piece, coarse = !both_fit(plan, fine);
    const int32 bits = coarse ? fine - FAR_COARSE : fine;
    const int32 off = coarse ? planes->count + 8 : FAR_OFF << piece;
    struct far_span span;

    if (coarse && !both_fit(plan, bits))
        return 0;
    if (s->renderer->only_counts)
        return 1;
    span.lines = planes->lines;
    span.count = planes->count;
    span.row = s->span.row;
    span.pitch = s->span.pitch;
    span.map = s->span.map;
    span.table = FAR_TABLE(plan->table);
    span.dqdx = dqdx;
    span.dqdy = upper(&planes->q.dy, 1);
    span.q = (uint32)upper(&planes->q.at, 1) - (uint32)dqdx * (uint32)(planes->left + EDGE_BIAS)
           - ((uint32)FAR_ORIGIN << 16);
    span.dq = swapped((leftwards ? -dqdx : dqdx) << piece);
    span.ku = raised(plan->ku, planes->u, planes->u_low, planes->u_high, off);
    span.kv = raised(plan->kv, planes->v, planes->v_low, planes->v_high, off);
    span.dcu = swapped(upper(&plan->dcu, bits));
    span.dcv = swapped(upper(&plan->dcv, bits));
    span.cu = swapped(upper(&plan->cu, bits) + 0x8000);
    span.cv = swapped(upper(&plan->cv, bits) + 0x8000);
    spans[piece == 4][coarse][leftwards](&span);
    return 1;
}
