#include "plain/glide.h"
#include "glide/unit.h"

void glide_walk_c(const struct pass_call *call)
{
    const struct glide_iterators *start = call->in;
    const struct glide_steps *step = call->constants;
    const int32 shift = step->shift, half = step->half;
    int32 s = start->s, t = start->t, count = call->count;
    uint32 *out = call->out;

    do {
        *out++ = (uint32)((s >> shift) - half) << 16 | (((t >> shift) - half) & 0xffff);
        s = (int32)((uint32)s + (uint32)step->s);
        t = (int32)((uint32)t + (uint32)step->t);
    } while (--count > 0);
}

static inline uint32 clamped(int32 coordinate, int32 last)
{
    if (last == 0xffff)
        return (uint32)coordinate & 0xffff;
    return (uint32)(coordinate < 0 ? 0 : coordinate > last ? last : coordinate);
}

void glide_walk_clamp_c(const struct pass_call *call)
{
    const struct glide_iterators *start = call->in;
    const struct glide_steps *step = call->constants;
    const int32 shift = step->shift, half = step->half;
    int32 s = start->s, t = start->t, count = call->count;
    uint32 *out = call->out;

    do {
        *out++ = clamped((s >> shift) - half, step->last_s) << 16
            | clamped((t >> shift) - half, step->last_t);
        s = (int32)((uint32)s + (uint32)step->s);
        t = (int32)((uint32)t + (uint32)step->t);
    } while (--count > 0);
}

static inline uint32 index_of(const struct glide_decoded *level, uint32 st)
{
    const uint32 s = st >> 16 & level->mask_s, t = st & level->mask_t;

    return t >> 4 << level->columns_bits | s >> 4;
}

void glide_point_c(const struct pass_call *call)
{
    const struct glide_decoded *level = call->constants;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do
        *out++ = level->texels[index_of(level, *in++)];
    while (--count > 0);
}

static inline uint32 sum(const struct glide_pair *pair, uint32 fs, uint32 ft)
{
    return pair->corner + fs * (pair->s + ft * pair->st) + ft * pair->t;
}

static inline uint32 filtered(const struct glide_decoded *level, uint32 st)
{
    const struct glide_quad *quads = level->quads, *quad = quads + index_of(level, st);
    const uint32 fs = st >> 16 & 15, ft = st & 15;

    return (sum(&quad->rb, fs, ft) & 0xff00ff00u) | (sum(&quad->ga, fs, ft) >> 8 & 0x00ff00ffu);
}

static inline uint32 packed(uint32 texel)
{
    return (texel >> 16 & 0xf800) | (texel >> 13 & 0x07e0) | (texel >> 11 & 0x001f);
}

void glide_bilinear_c(const struct pass_call *call)
{
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do
        *out++ = filtered(call->constants, *in++);
    while (--count > 0);
}

/* Of both sides' words, two channels each: their upper bytes. */
static inline uint32 weighed(const struct glide_pair_8 *pair, uint32 fs, uint32 ft)
{
    const uint32 upper = pair->upper + fs * pair->upper_s, lower = pair->lower + fs * pair->lower_s;
    const uint32 first = (upper >> 16) * (256 - ft) + (lower >> 16) * ft;
    const uint32 second = (upper & 0xffff) * (256 - ft) + (lower & 0xffff) * ft;

    return (first & 0xff0000) | second >> 16;
}

void glide_bilinear_8_c(const struct pass_call *call)
{
    const struct glide_decoded *level = call->constants;
    const uint32 mask_s = level->mask_s << 4, mask_t = level->mask_t << 4;
    const struct glide_quad_8 *quads = level->quads;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 st = *in++, s = st >> 16 & mask_s, t = st & mask_t;
        const struct glide_quad_8 *quad = &quads[t >> 8 << level->columns_bits | s >> 8];

        *out++ = weighed(&quad->rb, st >> 16 & 255, st & 255) << 8
            | weighed(&quad->ga, st >> 16 & 255, st & 255);
    } while (--count > 0);
}

void glide_bilinear_565_c(const struct pass_call *call)
{
    const uint32 *in = call->in;
    uint16 *out = call->out;
    int32 count = call->count;

    do
        *out++ = (uint16)packed(filtered(call->constants, *in++));
    while (--count > 0);
}

void glide_store_565_c(const struct pass_call *call)
{
    const uint32 *in = call->in;
    uint16 *out = call->out;
    int32 count = call->count;

    do
        *out++ = (uint16)packed(*in++);
    while (--count > 0);
}

void glide_widen_565_c(const struct pass_call *call)
{
    const uint16 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do
        *out++ = glide_wide_565(*in++);
    while (--count > 0);
}

/* Rows 128 to 255 lie before row 0. */
static inline int32 index_on_page(uint32 s, uint32 t)
{
    return (int16)((t >> 16 & 0xff00) | s >> 24);
}

void glide_tile_16_c(const struct pass_call *call)
{
    const struct glide_iterators *start = call->in;
    const struct glide_paging *paging = call->constants;
    const uint16 *page = paging->pixels;
    const int32 left = paging->left;
    uint32 s = (uint32)start->s << left, t = (uint32)start->t << left;
    const uint32 ds = (uint32)paging->s << left, dt = (uint32)paging->t << left;
    uint16 *out = call->out;

    for (int32 i = 0; i < call->count; i++, s += ds, t += dt)
        *out++ = page[index_on_page(s, t)];
}

void glide_tile_32_c(const struct pass_call *call)
{
    const struct glide_iterators *start = call->in;
    const struct glide_paging *paging = call->constants;
    const uint32 *page = paging->pixels;
    const int32 left = paging->left;
    uint32 s = (uint32)start->s << left, t = (uint32)start->t << left;
    const uint32 ds = (uint32)paging->s << left, dt = (uint32)paging->t << left;
    uint32 *out = call->out;

    for (int32 i = 0; i < call->count; i++, s += ds, t += dt)
        *out++ = page[index_on_page(s, t)];
}

void glide_quads_c(const struct pass_call *call)
{
    const uint32 *in = call->in;

    glide_quads_make(call->out, in, in + call->count, (uint32)call->count);
}

void glide_quads_8_c(const struct pass_call *call)
{
    const uint32 *in = call->in;

    glide_quads_8_make(call->out, in, in + call->count, (uint32)call->count);
}
