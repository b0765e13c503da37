#include "perspective/cubic.h"

#include "math/math.h"

static int32 bit_length(uint32 of)
{
    int32 bits = 0;

    for (int32 half = 16; half; half >>= 1)
        if (of >> half) {
            bits += half;
            of >>= half;
        }
    return bits + (int32)of;
}

/* Moves C of the first line and its growth by what far_constants has cut: rest, of the quotient by the height. */
static void refine(int32 *c, int32 *dc, uint32 *dc_low, int32 rest, fix16 height, fix16 down)
{
    const int32 part = mul_div(rest, 1 << 30, height);

    *c += mul_shift(part >> 15, down, 31);
    *dc += part >> 30;
    *dc_low = (uint32)part << 2;
}

/* Finds K. Returns the texels to it, or 0 if it is too far or cannot be told. */
static int32 find_k(struct far_way *way, const struct perspective_plan *planes)
{
    int32 reach = far_find_reach(way, planes, CUBIC_REACH / 4);     /* u - K is a long */

    return reach > CUBIC_REACH ? 0 : reach;
}

/* Finds the lengths of pieces and the factors of r. Pixels are exact if q, or u, grows too fast for those: if
   reach > CUBIC_STEEP 2 least / dq, whose product may exceed a longword where dq is small. */
static void find_steps(struct cubic_span *span, const struct cubic_fit *fit, int32 reach, uint32 least,
                       int32 bits)
{
    const uint32 dq = span->dq;

    span->most = 0;
    span->factors[0] = span->factors[1] = span->factors[2] = 0;
    if (dq >= 1u << (bits - 3) || (uint32)(reach - 1) / CUBIC_STEEP >= 2 * least / dq)
        return;
    span->most = (uint16)(fit->width / dq < 65535 ? fit->width / dq : 65535);
    for (int32 i = 0; i < 3; i++)
        span->factors[i] = -mul_shift((int32)dq, fit->factors[i], bits - 3);
}

/* Sets K, and raises it so that lines are never too low. lost: units by which q may be off. Returns 0 if that is
   too much. */
static int32 raise(struct cubic_span *span, const struct far_way *way, const struct setup *s,
                   int32 scale, int32 lost, int32 least, int32 bits)
{
    const struct perspective_plan *planes = s->perspective;
    const int32 is_fine = s->setting == PERSPECTIVE_FINE, less = way->plan.less;
    const int32 part = (lost << 18) / (least >> 6) + 1;         /* of a texel from K, 1/256 units */
    const int32 off = (is_fine ? CUBIC_CUTS_FINE : CUBIC_CUTS_PIXEL)
                    + (less ? 4 : 1) * ((1 << 30) / least + 1) + ((CUBIC_OFF_C << (31 - span->shift)) >> 1)
                    + 2 + (3 << (scale - 2)) / (least >> 4);
    const int32 off_u = off + (way->to_u * part >> 8) + (way->to_u >> 8) + (way->to_u >> (bits - 17));
    const int32 off_v = off + (way->to_v * part >> 8) + (way->to_v >> 8) + (way->to_v >> (bits - 17));
    const int32 most = is_fine ? CUBIC_RAISE_FINE : CUBIC_RAISE_PIXEL;

    span->ku = ((uint32)way->plan.ku << (8 - FAR_K_BITS + less)) + ((uint32)(planes->u + off_u) << 8);
    span->kv = ((uint32)way->plan.kv << (8 - FAR_K_BITS + less)) + ((uint32)(planes->v + off_v) << 8);
    return off_u <= most && off_v <= most;
}

int32 cubic_find(struct cubic_span *span, const struct setup *s, const struct depth *depth)
{
    const struct perspective_plan *planes = s->perspective;
    const int32 least = far_least(s, depth);
    const int32 lost = ((s->box.right - s->box.left + s->span.count) >> 2) + 1 + depth->off;
    struct far_way way;
    struct far_plan *plan = &way.plan;
    int32 bits, reach, row;

    if (!least || lost > CUBIC_OFF_Q)
        return 0;
    span->dq = fix_magnitude(cubic_nearest(&planes->q.dx));
    far_begin_plan(plan, depth);
    reach = find_k(&way, planes);
    if (!reach || !span->dq)
        return 0;
    bits = bit_length((uint32)least);
    row = bit_length((uint32)reach);
    span->shift = 13 - row + bits < 31 ? 13 - row + bits : 31;
    span->unshift = 32 - span->shift;
    span->top = 1u << (bits - 2);
    if (!raise(span, &way, s, depth->scale, lost, least, bits)
        || !far_find_c(plan, s, span->shift - bits + plan->less))
        return 0;
    span->cu = (int32)plan->cu;
    span->cv = (int32)plan->cv;
    span->dcu = (int32)plan->dcu;
    span->dcv = (int32)plan->dcv;
    refine(&span->cu, &span->dcu, &span->dcu_low, plan->rest_u, plan->bottom->y, depth->corners.y);
    refine(&span->cv, &span->dcv, &span->dcv_low, plan->rest_v, plan->bottom->y, depth->corners.y);
    row = (row > CUBIC_NEAR ? row - CUBIC_NEAR : 0) + (s->setting == PERSPECTIVE_FINE ? 2 : 0);
    find_steps(span, &cubic_fits[row], reach, (uint32)least, bits);
    span->longest = (uint16)((s->setting == PERSPECTIVE_FINE ? CUBIC_LONGEST_FINE : CUBIC_LONGEST_PIXEL) - 1);
    return 1;
}

void cubic_draw(const struct setup *s, struct cubic_span *span, const struct far_line *lines)
{
    span->lines = lines;
    span->count = s->span.count;
    span->map = s->span.map;
    ((int32)s->perspective->q.dx.hi < 0 ? span_cubic_left : span_cubic_right)(span);
}
