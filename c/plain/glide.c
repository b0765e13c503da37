#include "plain/glide.h"

#include "glide/polygons/plan.h"

void glide_combine_line_c(const struct pass_call *call)
{
    const struct glide_combine_call *given = call->constants;
    struct glide_combining combining;
    struct glide_factors factors;
    uint32 *out = call->out;
    struct glide_known known;

    known.detail = given->detail;
    known.fraction = given->fraction;
    known.flip = given->flip;
    glide_combining_find(&combining, &given->modes, &known, given->has_other, given->has_alpha);
    factors.details = given->details;
    factors.fractions = given->fractions;
    factors.detail_step = given->detail_step;
    factors.fraction_step = given->fraction_step;
    factors.flip = given->modes.trilinear && given->odd ? 255 : 0;
    glide_combine_line(&combining, &given->modes, &factors, call->in,
                       given->has_other ? given->other : 0, out, call->count);
    if (!given->has_alpha)
        for (int32 n = 0; n < call->count; n++)
            out[n] &= 0xffffff00;
}

void glide_logarithms_c(const struct pass_call *call)
{
    glide_logarithms_make(call->out, call->in);
}

void glide_products_c(const struct pass_call *call)
{
    glide_products_make(call->out);
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
