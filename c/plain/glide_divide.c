#include "math/math.h"
#include "plain/glide.h"

/* n * 2^bits / w rounded down, n < 2 w. */
static uint32 quotient(uint32 n, uint32 w, int32 bits, uint32 *rest)
{
    uint32 found = n >= w;

    n -= found ? w : 0;
    for (; bits; bits--) {
        const uint32 carry = n >> 31;

        n <<= 1;
        found <<= 1;
        if (carry || n >= w) {
            n -= w;
            found++;
        }
    }
    *rest = n;
    return found;
}

/* s * 2^30 / w rounded down, cut to 32 bits, >> shift. */
static int32 divided(int32 s, int32 w, int32 shift)
{
    const uint32 n = fix_magnitude(s), by = fix_magnitude(w);
    uint32 rest, found;

    if (n >> 1 >= by) {
        found = (1u << (31 - shift)) - 1;
        rest = 1;
    } else {
        found = quotient(n, by, 30 - shift, &rest);
    }
    return (int32)((s < 0) != (w < 0) ? 0 - found - (rest != 0) : found);
}

static inline uint32 coordinate(int32 s, int32 w, const struct glide_steps *step, int32 last)
{
    int32 found = (!w || (w < 0 && step->behind) ? 0 : divided(s, w, step->shift)) - step->half;

    if (last == 0xffff)
        return (uint32)found & 0xffff;
    return (uint32)(found < 0 ? 0 : found > last ? last : found);
}

void glide_divide_c(const struct pass_call *call)
{
    const struct glide_iterators *start = call->in;
    const struct glide_steps *step = call->constants;
    int32 s = start->s, t = start->t, w = start->w, count = call->count;
    uint32 *out = call->out;

    do {
        *out++ = coordinate(s, w, step, step->last_s) << 16 | coordinate(t, w, step, step->last_t);
        s = (int32)((uint32)s + (uint32)step->s);
        t = (int32)((uint32)t + (uint32)step->t);
        w = (int32)((uint32)w + (uint32)step->w);
    } while (--count > 0);
}

static int32 divided_at(int32 s, int32 w, const struct glide_steps *step)
{
    return !w || (w < 0 && step->behind) ? 0 : divided(s, w, 0);
}

static uint32 level_coordinate(int32 value, const struct glide_steps *step, int32 last)
{
    const int32 found = (value >> step->shift) - step->half;

    if (last == 0xffff)
        return (uint32)found & 0xffff;
    return (uint32)(found < 0 ? 0 : found > last ? last : found);
}

/* What takes a value from one number to another, rounded down. */
static int32 step_of(int32 from, int32 to, int32 pixels)
{
    const int32 way = (int32)((uint32)to - (uint32)from), step = way / pixels;

    return step * pixels > way ? step - 1 : step;
}

void glide_pieces_c(const struct pass_call *call)
{
    const struct glide_iterators *start = call->in;
    const struct glide_steps *step = call->constants;
    int32 s_over_w = start->s, t_over_w = start->t, w = start->w;
    int32 s0 = divided_at(s_over_w, w, step), t0 = divided_at(t_over_w, w, step);
    int32 skip = step->skip, left = step->left - 1, count = call->count;
    const int32 whole = 1 << step->bits;
    uint32 *out = call->out;

    while (count > 0) {
        const int32 pixels = left < whole ? left : whole;
        int32 s = s0, t = t0, ds = 0, dt = 0;

        if (pixels) {
            s_over_w = (int32)((uint32)s_over_w + (uint32)pixels * (uint32)step->s);
            t_over_w = (int32)((uint32)t_over_w + (uint32)pixels * (uint32)step->t);
            w = (int32)((uint32)w + (uint32)pixels * (uint32)step->w);
            s0 = divided_at(s_over_w, w, step);
            t0 = divided_at(t_over_w, w, step);
            ds = step_of(s, s0, pixels);
            dt = step_of(t, t0, pixels);
        }
        for (int32 i = 0; i < whole && count > 0; i++) {
            if (i >= skip) {
                *out++ = level_coordinate(s, step, step->last_s) << 16
                    | level_coordinate(t, step, step->last_t);
                count--;
            }
            s = (int32)((uint32)s + (uint32)ds);
            t = (int32)((uint32)t + (uint32)dt);
        }
        skip = 0;
        left -= whole;
    }
}

/* A pixel's LOD. */
static inline int32 lod_of(int32 w, int32 lod, const struct glide_lods *lods)
{
    const struct glide_logarithm *entry;
    uint32 size = fix_magnitude(w);

    if (!size)
        return lods->most;
    for (; !(size >> 31); size <<= 1)
        lod += 256;
    entry = &lods->logarithms[size >> 22 & 511];
    lod -= entry->value + (size > entry->limit);
    return lod < lods->least ? lods->least : lod > lods->most ? lods->most : lod;
}

void glide_lod_c(const struct pass_call *call)
{
    const struct glide_lods *lods = call->constants;
    int32 w = ((const struct glide_iterators *)call->in)->w, count = call->count;
    uint16 *out = call->out;

    for (int32 i = 0; i < count; i++) {
        *out++ = (uint16)lod_of(w, lods->lods[i & 3], lods);
        w = (int32)((uint32)w + (uint32)lods->w);
    }
}

void glide_details_c(const struct pass_call *call)
{
    const struct glide_nearness *nearness = call->constants;
    const uint16 *lods = call->in;
    uint8 *out = call->out;
    int32 count = call->count;

    do
        *out++ = (uint8)((nearness->end - *lods++) >> nearness->shift);
    while (--count > 0);
}

void glide_interleave_c(const struct pass_call *call)
{
    const struct glide_quarters *quarters = call->constants;
    const uint8 *in = call->in;
    uint32 *out = call->out;

    for (int32 i = 0; i < call->count; i++)
        *out++ = *(const uint32 *)(in + (i & 3) * quarters->bytes + (i & ~3));
}

void glide_logarithms_c(const struct pass_call *call)
{
    glide_logarithms_make(call->out, call->in);
}
