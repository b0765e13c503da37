#include "plain/n64.h"

/* s and t at a point, and whether either overflows 17 bits. */
struct quotients {
    int32 s, t, is_far;
};

/* Reciprocal and shifts are taken apart again, as C has no product of 64 bits. */
static inline void divide(struct quotients *q, const uint32 *reciprocals, int32 s, int32 t, int32 w)
{
    int32 shifts = 0, r;

    w >>= 16;
    q->is_far = 1;
    q->s = q->t = 32767;
    if (w <= 0)
        return;
    while (!(w << shifts & 0x4000))
        shifts++;
    r = w == 1 ? 0x4000 : (int32)(reciprocals[w] >> (3 + shifts));
    s = (s >> 16) * r;
    t = (t >> 16) * r;
    q->s = shifts == 14 ? s * 2 : s >> (13 - shifts);
    q->t = shifts == 14 ? t * 2 : t >> (13 - shifts);
    q->is_far = q->s < -65536 || q->s > 65535 || q->t < -65536 || q->t > 65535;
}

static inline uint32 nearest(int32 value)
{
    return (uint32)(value > 32767 ? 32767 : value < -32768 ? -32768 : value) & 0xffff;
}

void n64_divide_c(const struct pass_call *call)
{
    const struct n64_iterators *start = call->in;
    const struct n64_division *step = call->constants;
    int32 s = start->s, t = start->t, w = start->w, count = call->count;
    uint32 *out = call->out;
    struct quotients q;

    do {
        divide(&q, step->reciprocals, s, t, w);
        *out++ = nearest(q.s) << 16 | nearest(q.t);
        s += step->s;
        t += step->t;
        w += step->w;
    } while (--count > 0);
}

static int32 longer(int32 most, int32 change)
{
    if (change < 0)
        change = ~change;
    return change > most ? change : most;
}

void n64_lod_c(const struct pass_call *call)
{
    const struct n64_iterators *start = call->in;
    const struct n64_lod_steps *d = call->constants;
    int32 s = start->s, t = start->t, w = start->w, count = call->count;
    uint32 *out = call->out, *blending = (uint32 *)d->blendings;
    struct quotients q, x, y;

    do {
        int32 lod = 0;

        divide(&q, d->reciprocals, s, t, w);
        *out++ = nearest(q.s) << 16 | nearest(q.t);
        divide(&x, d->reciprocals, s + (d->x_s & ~31), t + (d->x_t & ~31), w + (d->x_w & ~31));
        divide(&y, d->reciprocals, s + (d->y_s & ~0x7fff), t + (d->y_t & ~0x7fff),
               w + (d->y_w & ~0x7fff));
        lod = longer(longer(lod, x.s - q.s), x.t - q.t);
        lod = longer(longer(lod, y.s - q.s), y.t - q.t);
        if (q.is_far || x.is_far || y.is_far || lod >= 0x4000) {
            *blending++ = d->levels->far;
        } else if (lod < 32) {
            *blending++ = d->levels->magnified[lod];
        } else {
            const uint32 level = d->levels->levels[lod >> 5];

            *blending++ = (level & 0xffff0000u)
                | (((uint32)lod * 8 >> (level >> 8 & 255) | level) & 255);
        }
        s += d->s;
        t += d->t;
        w += d->w;
    } while (--count > 0);
}
