#include "plain/glide.h"

#define FIELD 0x00ff00ffu

/* The factor of the next pixel, of 256. */
static inline int32 factor_of(const struct glide_mix *mix, const uint8 **factors)
{
    const int32 factor = (**factors ^ (mix->flip & 255)) + mix->one;

    *factors += mix->factor_step;
    return factor;
}

static inline uint32 next(const struct glide_mix *mix, const uint8 **other)
{
    const uint32 texel = *(const uint32 *)*other;

    *other += mix->other_step;
    return texel;
}

void glide_lerp_c(const struct pass_call *call)
{
    const struct glide_mix *mix = call->constants;
    const uint8 *factors = mix->factors, *others = (const uint8 *)mix->other;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 factor = (uint32)factor_of(mix, &factors), a = *in++, b = next(mix, &others);
        const uint32 rb = a >> 8 & FIELD, ga = a & FIELD;

        *out++ = ((256 * rb + ((b >> 8 & FIELD) - rb) * factor) & ~FIELD)
            | ((256 * ga + ((b & FIELD) - ga) * factor) >> 8 & FIELD);
    } while (--count > 0);
}

void glide_scale_c(const struct pass_call *call)
{
    const struct glide_mix *mix = call->constants;
    const uint8 *factors = mix->factors;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 factor = (uint32)factor_of(mix, &factors), texel = *in++;

        *out++ = ((texel >> 8 & FIELD) * factor & ~FIELD)
            | ((texel & FIELD) * factor >> 8 & FIELD);
    } while (--count > 0);
}

static inline uint32 product(uint32 a, uint32 b)
{
    return (a & 255) * ((b & 255) + 1) >> 8;
}

void glide_modulate_c(const struct pass_call *call)
{
    const struct glide_mix *mix = call->constants;
    const uint8 *others = (const uint8 *)mix->other;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 a = *in++, b = next(mix, &others) ^ mix->flip;

        *out++ = product(a >> 24, b >> 24) << 24 | product(a >> 16, b >> 16) << 16
            | product(a >> 8, b >> 8) << 8 | product(a, b);
    } while (--count > 0);
}

void glide_modulate_rgb_c(const struct pass_call *call)
{
    const struct glide_mix *mix = call->constants;
    const uint8 *others = (const uint8 *)mix->other;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 a = *in++, b = next(mix, &others) ^ mix->flip;

        *out++ = product(a >> 24, b >> 24) << 24 | product(a >> 16, b >> 16) << 16
            | product(a >> 8, b >> 8) << 8 | (a & 255);
    } while (--count > 0);
}

/* Two channels' sums, 255 at most. */
static inline uint32 sums(uint32 a, uint32 b)
{
    const uint32 sum = (a & FIELD) + (b & FIELD), over = sum & 0x01000100;

    return (sum | (over - (over >> 8))) & FIELD;
}

void glide_add_c(const struct pass_call *call)
{
    const struct glide_mix *mix = call->constants;
    const uint8 *others = (const uint8 *)mix->other;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 a = *in++, b = next(mix, &others);

        *out++ = sums(a >> 8, b >> 8) << 8 | sums(a, b);
    } while (--count > 0);
}

void glide_alpha_c(const struct pass_call *call)
{
    const struct glide_alphas *from = call->constants;
    const uint8 *alphas = from->alphas;
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        *out++ = ((*in++ & 0xffffff00) | *alphas) ^ from->inverted;
        alphas += from->step;
    } while (--count > 0);
}

void glide_combiner_c(const struct pass_call *call)
{
    const struct glide_inputs *inputs = call->constants;
    const uint8 *other = inputs->other, *local = inputs->local, *factor = inputs->factor,
        *added = inputs->added;
    uint8 *out = call->out;
    int32 count = call->count;

    do {
        int32 value = ((*other - *local) * ((*factor ^ inputs->flip) + 1) >> 8) + *added;

        value = value < 0 ? 0 : value > 255 ? 255 : value;
        *out = (uint8)(value ^ inputs->invert);
        out += 4;
        other += inputs->other_step;
        local += inputs->local_step;
        factor += inputs->factor_step;
        added += inputs->added_step;
    } while (--count > 0);
}
