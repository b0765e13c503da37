/* Colour conversion: YUV to RGB by K0 to K3. */
#include "n64/bits.h"
#include "n64/passes.h"
#include "n64/texel.h"

void n64_convert_texel(const struct n64 *n64, const struct n64_colour *yuv, struct n64_colour *out)
{
    const int32 u = yuv->r, v = yuv->g, y = yuv->b;
    const int16 *k = n64->k;

    out->r = (int16)n64_signed_9(y + (((2 * k[0] + 1) * v + 128) >> 8));
    out->g = (int16)n64_signed_9(y + (((2 * k[1] + 1) * u + (2 * k[2] + 1) * v + 128) >> 8));
    out->b = (int16)n64_signed_9(y + (((2 * k[3] + 1) * u + 128) >> 8));
    out->a = (int16)n64_signed_9(y);
}

/* Of green's addend and the other one, both in 1/256. */
static uint32 addend(int32 green, int32 other)
{
    return (uint32)green << 15 | ((uint32)other >> 8 & 0x1ff);
}

void n64_matrix_make(struct n64_matrix *matrix, const int16 *k)
{
    for (int32 i = 0; i < 256; i++) {
        const int32 chroma = i - 128;

        matrix->u[i] = addend((2 * k[1] + 1) * chroma + 128, (2 * k[3] + 1) * chroma + 128);
        matrix->v[i] = addend((2 * k[2] + 1) * chroma, (2 * k[0] + 1) * chroma + 128);
    }
}
