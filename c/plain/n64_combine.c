#include "plain/n64.h"

static uint32 product(uint32 a, uint32 b)
{
    return ((a & 255) * (b & 255) + 128) >> 8;
}

static inline uint32 integer(int32 shade)
{
    const int32 value = shade >> 16;

    return value < 0 ? 0 : value > 255 ? 255 : (uint32)value;
}

void n64_shade_c(const struct pass_call *call)
{
    const struct n64_shades *start = call->in, *step = call->constants;
    int32 r = start->r, g = start->g, b = start->b, a = start->a, count = call->count;
    uint32 *out = call->out;

    do {
        *out++ = integer(r) << 24 | integer(g) << 16 | integer(b) << 8 | integer(a);
        r += step->r;
        g += step->g;
        b += step->b;
        a += step->a;
    } while (--count > 0);
}

void n64_modulate_c(const struct pass_call *call)
{
    const struct n64_modulation *modulation = call->constants;
    const uint8 *other = (const uint8 *)modulation->other;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 a = *in++, b = *(const uint32 *)other;

        other += modulation->step;
        *out++ = product(a >> 24, b >> 24) << 24 | product(a >> 16, b >> 16) << 16
            | product(a >> 8, b >> 8) << 8 | product(a, b);
    } while (--count > 0);
}

void n64_map_c(const struct pass_call *call)
{
    const uint8 *tables = call->constants, *in = call->in;
    uint8 *out = call->out;
    int32 count = call->count;

    do {
        out[0] = tables[in[0]];
        out[1] = tables[256 + in[1]];
        out[2] = tables[512 + in[2]];
        out[3] = tables[768 + in[3]];
        in += 4;
        out += 4;
    } while (--count > 0);
}

void n64_widen_c(const struct pass_call *call)
{
    const uint8 *in = call->in;
    int16 *out = call->out;
    int32 count = 4 * call->count;

    do
        *out++ = *in++;
    while (--count > 0);
}

void n64_combiner_c(const struct pass_call *call)
{
    const struct n64_combination *inputs = call->constants;
    const uint8 *a = (const uint8 *)inputs->a, *b = (const uint8 *)inputs->b;
    const uint8 *c = (const uint8 *)inputs->c, *d = (const uint8 *)inputs->d;
    struct n64_wide *out = call->out;
    int32 count = call->count;

    do {
        const int32 factor = ((*(const int16 *)c + 256) & 511) - 256;
        const int32 value = (*(const int16 *)a - *(const int16 *)b) * factor
            + 256 * *(const int16 *)d + 128;

        out++->channels[0] = (int16)((((value >> 8) + 128) & 511) - 128);
        a += inputs->a_step;
        b += inputs->b_step;
        c += inputs->c_step;
        d += inputs->d_step;
    } while (--count > 0);
}

void n64_narrow_c(const struct pass_call *call)
{
    const int16 *in = call->in;
    uint8 *out = call->out;
    int32 count = 4 * call->count;

    do {
        const int32 value = *in++;

        *out++ = (uint8)(value < 0 ? 0 : value > 255 ? 255 : value);
    } while (--count > 0);
}

void n64_levels_c(const struct pass_call *call)
{
    n64_levels_make(call->out, call->constants);
}
