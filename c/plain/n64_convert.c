#include "plain/n64.h"

void n64_chroma_c(const struct pass_call *call)
{
    const uint32 *in = call->in;
    uint32 *out = call->out;
    int32 count = call->count;

    do {
        const uint32 st = *in++;

        *out++ = (st & 0xffe0ffffu) | (st >> 1 & 0x001f0000u);
    } while (--count > 0);
}

/* Sums of Y and what U and V add. */
struct sums {
    int32 r, g, b, y;
};

static inline void convert(struct sums *to, const struct n64_matrix *matrix, uint32 chroma,
                           uint32 luma)
{
    const struct n64_addend *u = &matrix->u[chroma >> 24], *v = &matrix->v[chroma >> 16 & 255];
    const int32 y = (int32)(luma & 255);

    to->r = y + v->other;
    to->g = y + ((u->green + v->green) >> 16);
    to->b = y + u->other;
    to->y = y;
}

void n64_convert_c(const struct pass_call *call)
{
    const struct n64_yuv_conversion *by = call->constants;
    const uint32 *in = call->in, *chroma = by->chroma;
    uint32 *out = call->out;
    int32 count = call->count;
    struct sums at;

    do {
        convert(&at, by->matrix, *chroma++, *in++);
        *out++ = (by->colours[at.r & 511] & 0xff000000u)
            | (by->colours[at.g & 511] & 0x00ff0000u) | (by->colours[at.b & 511] & 0x0000ff00u)
            | (by->colours[at.y] & 0x000000ffu);
    } while (--count > 0);
}

static inline int16 extended(int32 value)
{
    return (int16)(((value + 128) & 511) - 128);
}

void n64_convert_wide_c(const struct pass_call *call)
{
    const struct n64_yuv_conversion *by = call->constants;
    const uint32 *in = call->in, *chroma = by->chroma;
    struct n64_wide *out = call->out;
    int32 count = call->count;
    struct sums at;

    do {
        convert(&at, by->matrix, *chroma++, *in++);
        out->channels[0] = extended(at.r);
        out->channels[1] = extended(at.g);
        out->channels[2] = extended(at.b);
        out->channels[3] = (int16)at.y;
        out++;
    } while (--count > 0);
}

void n64_matrix_c(const struct pass_call *call)
{
    n64_matrix_make(call->out, call->in);
}
