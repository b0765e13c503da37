/* Functions and factors of the combine unit. */
#include "glide/glide.h"

enum term { ZERO_OTHER = 1, SUB_LOCAL = 2, ADD_LOCAL = 4, ADD_ALPHA = 8 };

static const uint8 terms[GLIDE_FUNCTIONS] = {
    ZERO_OTHER, ZERO_OTHER | ADD_LOCAL, ZERO_OTHER | ADD_ALPHA,                 /* zero, local */
    0, ADD_LOCAL, ADD_ALPHA,                                                    /* scale other */
    SUB_LOCAL, SUB_LOCAL | ADD_LOCAL, SUB_LOCAL | ADD_ALPHA,                    /* minus local */
    ZERO_OTHER | SUB_LOCAL | ADD_LOCAL, ZERO_OTHER | SUB_LOCAL | ADD_ALPHA      /* blend local */
};

static enum glide_result set(struct glide_combination *to, uint32 function, uint32 factor,
                             uint32 invert)
{
    if (function >= GLIDE_FUNCTIONS)
        return GLIDE_BAD_FUNCTION;
    if ((factor & ~(uint32)GLIDE_FACTOR_ONE) > GLIDE_FACTOR_LOD_FRACTION)
        return GLIDE_BAD_FACTOR;
    if (invert > 1)
        return GLIDE_BAD_FLAG;
    to->zero_other = (terms[function] & ZERO_OTHER) != 0;
    to->sub_local = (terms[function] & SUB_LOCAL) != 0;
    to->add_local = (terms[function] & ADD_LOCAL) != 0;
    to->add_alpha_local = (terms[function] & ADD_ALPHA) != 0;
    to->mselect = factor & 7;
    to->reverse = factor < GLIDE_FACTOR_ONE;
    to->invert = (uint8)invert;
    return GLIDE_DONE;
}

enum glide_result glide_combine(struct glide *glide, uint32 rgb_function, uint32 rgb_factor,
                                uint32 alpha_function, uint32 alpha_factor, uint32 invert_rgb,
                                uint32 invert_alpha)
{
    struct glide_modes modes = glide->modes;
    enum glide_result result = set(&modes.rgb, rgb_function, rgb_factor, invert_rgb);

    if (result == GLIDE_DONE)
        result = set(&modes.alpha, alpha_function, alpha_factor, invert_alpha);
    if (result == GLIDE_DONE)
        glide_set_modes(glide, &modes);
    return result;
}
