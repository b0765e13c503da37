/* Functions and factors of the combine unit. */
#include "tmu/tmu.h"

enum term { ZERO_OTHER = 1, SUB_LOCAL = 2, ADD_LOCAL = 4, ADD_ALPHA = 8 };

static const uint8 terms[TMU_FUNCTIONS] = {
    ZERO_OTHER,
    ZERO_OTHER | ADD_LOCAL,
    ZERO_OTHER | ADD_ALPHA,
    0,
    ADD_LOCAL,
    ADD_ALPHA,
    SUB_LOCAL,
    SUB_LOCAL | ADD_LOCAL,
    SUB_LOCAL | ADD_ALPHA,
    ZERO_OTHER | SUB_LOCAL | ADD_LOCAL,
    ZERO_OTHER | SUB_LOCAL | ADD_ALPHA
};

static enum tmu_result set(struct tmu_combination *to, uint32 function, uint32 factor,
                           uint32 invert)
{
    if (function >= TMU_FUNCTIONS)
        return TMU_BAD_FUNCTION;
    if ((factor & ~(uint32)TMU_FACTOR_ONE) > TMU_FACTOR_LOD_FRACTION)
        return TMU_BAD_FACTOR;
    if (invert > 1)
        return TMU_BAD_FLAG;
    to->zero_other = (terms[function] & ZERO_OTHER) != 0;
    to->sub_local = (terms[function] & SUB_LOCAL) != 0;
    to->add_local = (terms[function] & ADD_LOCAL) != 0;
    to->add_alpha_local = (terms[function] & ADD_ALPHA) != 0;
    to->mselect = factor & 7;
    to->reverse = factor < TMU_FACTOR_ONE;
    to->invert = (uint8)invert;
    return TMU_DONE;
}

enum tmu_result tmu_combine(struct tmu *tmu, uint32 rgb_function, uint32 rgb_factor,
                            uint32 alpha_function, uint32 alpha_factor, uint32 invert_rgb,
                            uint32 invert_alpha)
{
    struct tmu_modes modes = tmu->modes;
    enum tmu_result result = set(&modes.rgb, rgb_function, rgb_factor, invert_rgb);

    if (result == TMU_DONE)
        result = set(&modes.alpha, alpha_function, alpha_factor, invert_alpha);
    if (result == TMU_DONE)
        tmu_set_modes(tmu, &modes);
    return result;
}
