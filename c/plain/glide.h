/* Routines of Glide's texture unit in C, called like passes. */
#ifndef PLAIN_GLIDE_H
#define PLAIN_GLIDE_H

#include "glide/glide.h"
#include "glide/passes.h"
#include "plain/call.h"

/* A line through the combine unit: glide_combining_find and glide_combine_line. */
struct glide_combine_call {
    struct glide_modes modes;
    const uint32 *other;
    const uint8 *details, *fractions;
    int32 detail_step, fraction_step;
    int32 detail, fraction, flip;       /* as in struct glide_known */
    uint8 odd;                  /* 1: the level is odd */
    uint8 has_other, has_alpha, spare;
};

/* in: the local texels. Without has_alpha alpha becomes 0. */
void glide_combine_line_c(const struct pass_call *call);

/* glide_logarithms_make; in: the limits. */
void glide_logarithms_c(const struct pass_call *call);

/* glide_products_make. */
void glide_products_c(const struct pass_call *call);

/* glide_quads_make and glide_quads_8_make; in: two rows, one after the other. */
void glide_quads_c(const struct pass_call *call);
void glide_quads_8_c(const struct pass_call *call);

#endif
