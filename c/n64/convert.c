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

void n64_matrix_make(struct n64_matrix *matrix, const int16 *k)
{
    for (int32 i = 0; i < 256; i++) {
        const int32 chroma = i - 128;

        matrix->u[i].green = 256 * ((2 * k[1] + 1) * chroma + 128);
        matrix->u[i].other = (int16)(((2 * k[3] + 1) * chroma + 128) >> 8);
        matrix->v[i].green = 256 * ((2 * k[2] + 1) * chroma);
        matrix->v[i].other = (int16)(((2 * k[0] + 1) * chroma + 128) >> 8);
        matrix->u[i].spare = matrix->v[i].spare = 0;
    }
}
