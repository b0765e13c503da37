/* What the combiner's codes come to. */
#include "tx/lower.h"

enum codes { COMBINED = 0, TEXEL0 = 1, ZERO_C = 16, ZERO_ALPHA_C = 7 };

/* Whether a cycle's result is one of its inputs, as it is. */
static int32 is_input(const struct tx_combine *combine, int32 cycle, uint32 code)
{
    const struct tx_input *rgb = &combine->rgb[cycle], *alpha = &combine->alpha[cycle];

    return (rgb->a == rgb->b || rgb->c >= ZERO_C) && rgb->d == code
        && (alpha->a == alpha->b || alpha->c >= ZERO_ALPHA_C) && alpha->d == code;
}

int32 tx_combine_is_texel(const struct tx *tx)
{
    const struct tx_combine *combine = &tx->combine;

    if (tx->modes.cycle == TX_ONE_CYCLE)
        return is_input(combine, 1, TEXEL0);
    return is_input(combine, 0, TEXEL0) && is_input(combine, 1, COMBINED);
}
