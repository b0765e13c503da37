/* Colour conversion: YUV to RGB by K0 to K3. */
#include "tx/bits.h"
#include "tx/texel.h"

void tx_convert_texel(const struct tx *tx, const struct tx_colour *yuv, struct tx_colour *out)
{
    const int32 u = yuv->r, v = yuv->g, y = yuv->b;
    const int16 *k = tx->k;

    out->r = (int16)tx_signed_9(y + (((2 * k[0] + 1) * v + 128) >> 8));
    out->g = (int16)tx_signed_9(y + (((2 * k[1] + 1) * u + (2 * k[2] + 1) * v + 128) >> 8));
    out->b = (int16)tx_signed_9(y + (((2 * k[3] + 1) * u + 128) >> 8));
    out->a = (int16)tx_signed_9(y);
}
