#include "tx/plain.h"

void tx_walk_c(const struct tx_call *call)
{
    const struct tx_iterators *start = call->in, *step = call->constants;
    int32 s = start->s, t = start->t, count = call->count;
    uint32 *out = call->out;

    do {
        *out++ = ((uint32)s & 0xffff0000u) | (uint32)t >> 16;
        s += step->s;
        t += step->t;
    } while (--count > 0);
}

void tx_threepoint_c(const struct tx_call *call)
{
    const struct tx_decoded *tile = call->constants;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 s = *in >> 16, t = *in++ & 0xffff;
        const struct tx_quad *quad = tile->quads
            + ((t & tile->mask_t) >> 5 << tile->columns_bits | (s & tile->mask_s) >> 5);
        const struct tx_triangle *triangle = &quad->lower;
        uint32 fs = s & 31, ft = t & 31;

        if (fs + ft >= 32) {
            triangle = &quad->upper;
            fs = 32 - fs;
            ft = 32 - ft;
        }
        *out++ = ((triangle->rb + fs * triangle->rb_s + ft * triangle->rb_t) & 0xff00ff00u)
            | ((triangle->ga + fs * triangle->ga_s + ft * triangle->ga_t) >> 8 & 0x00ff00ffu);
    } while (--count > 0);
}

void tx_quads_c(const struct tx_call *call)
{
    const uint32 *in = call->in;
    struct tx_quad *out = call->out;
    int32 count = call->count;

    do {
        tx_quad_make(out++, in[0], in[1], in[2], in[3]);
        in += 4;
    } while (--count > 0);
}
