#include "plain/n64.h"

void n64_walk_c(const struct pass_call *call)
{
    const struct n64_iterators *start = call->in, *step = call->constants;
    int32 s = start->s, t = start->t, count = call->count;
    uint32 *out = call->out;

    do {
        *out++ = ((uint32)s & 0xffff0000u) | (uint32)t >> 16;
        s += step->s;
        t += step->t;
    } while (--count > 0);
}

/* The quad of a pair of coordinates. */
static inline const struct n64_quad *quad_at(const struct n64_decoded *tile, uint32 st)
{
    const uint32 s = st >> 16 & tile->mask_s, t = st & tile->mask_t;

    return tile->quads + (t >> 5 << tile->columns_bits | s >> 5);
}

static inline uint32 filtered(const struct n64_quad *quad, uint32 st)
{
    const struct n64_triangle *triangle = &quad->lower;
    uint32 fs = st >> 16 & 31, ft = st & 31;

    if (fs + ft >= 32) {
        triangle = &quad->upper;
        fs = 32 - fs;
        ft = 32 - ft;
    }
    return ((triangle->rb + fs * triangle->rb_s + ft * triangle->rb_t) & 0xff00ff00u)
        | ((triangle->ga + fs * triangle->ga_s + ft * triangle->ga_t) >> 8 & 0x00ff00ffu);
}

static inline uint32 packed(uint32 texel)
{
    return (texel >> 16 & 0xf800) | (texel >> 13 & 0x07c0) | (texel >> 10 & 0x003e)
        | (texel >> 7 & 1);
}

void n64_threepoint_c(const struct pass_call *call)
{
    const struct n64_decoded *tile = call->constants;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 st = *in++;

        *out++ = filtered(quad_at(tile, st), st);
    } while (--count > 0);
}

void n64_threepoint_16_c(const struct pass_call *call)
{
    const struct n64_decoded *tile = call->constants;
    const uint32 *in = call->in;
    uint16 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 st = *in++;

        *out++ = (uint16)packed(filtered(quad_at(tile, st), st));
    } while (--count > 0);
}

void n64_average_c(const struct pass_call *call)
{
    const struct n64_decoded *tile = call->constants;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 st = *in++;
        const struct n64_quad *quad = quad_at(tile, st);

        *out++ = (st & 0x001f001f) != 0x00100010 ? filtered(quad, st)
            : (quad->mean_rb & 0xff00ff00u) | (quad->mean_ga >> 8 & 0x00ff00ffu);
    } while (--count > 0);
}

void n64_point_c(const struct pass_call *call)
{
    const struct n64_decoded *tile = call->constants;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 s = *in >> 16, t = *in++ & 0xffff;

        *out++ = tile->texels[(t & tile->mask_t) >> 5 << tile->columns_bits
                              | (s & tile->mask_s) >> 5];
    } while (--count > 0);
}

void n64_store_16_c(const struct pass_call *call)
{
    const uint32 *in = call->in;
    uint16 *out = call->out;
    int32 count = call->count;

    do
        *out++ = (uint16)packed(*in++);
    while (--count > 0);
}

static uint32 relative(int32 c, const struct n64_axis_range *axis)
{
    c = axis->shift >= 0 ? c >> axis->shift : (int16)((uint32)c << -axis->shift);
    if (!axis->clamp)
        return (uint32)(c - axis->low) & 0xffff;
    if (c >= axis->high)
        return (uint32)axis->last;
    return c < axis->low ? 0 : (uint32)(c - axis->low);
}

void n64_tile_c(const struct pass_call *call)
{
    const struct n64_axes *axes = call->constants;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        *out++ = relative((int16)(*in >> 16), &axes->s) << 16 | relative((int16)*in, &axes->t);
        in++;
    } while (--count > 0);
}

static uint32 blended(uint32 texel, uint32 other, int32 fraction)
{
    const int32 a = (int32)(texel & 255), b = (int32)(other & 255);
    const uint32 value = (uint32)(((b - a) * fraction + 256 * a + 128) >> 8) & 0x1ff;

    return value < 256 ? value : value < 384 ? 255 : 0;
}

void n64_lerp_c(const struct pass_call *call)
{
    const struct n64_blend *blend = call->constants;
    const uint8 *fractions = (const uint8 *)blend->fractions;
    const uint32 *in = call->in, *other = blend->other;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 a = *in++, b = *other++;
        const int32 fraction = *(const int16 *)fractions;

        fractions += blend->fraction_step;
        *out++ = blended(a >> 24, b >> 24, fraction) << 24
            | blended(a >> 16, b >> 16, fraction) << 16
            | blended(a >> 8, b >> 8, fraction) << 8 | blended(a, b, fraction);
    } while (--count > 0);
}

void n64_reciprocals_c(const struct pass_call *call)
{
    n64_divide_table_make(call->out);
}
