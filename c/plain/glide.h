/* The passes in plain C: the yardsticks of the bench. */
#ifndef PLAIN_GLIDE_H
#define PLAIN_GLIDE_H

#include "plain/call.h"
#include "glide/passes.h"
#include "glide/glide.h"

void glide_walk_c(const struct pass_call *call);
void glide_walk_clamp_c(const struct pass_call *call);
void glide_divide_c(const struct pass_call *call);
void glide_pieces_c(const struct pass_call *call);
void glide_lod_c(const struct pass_call *call);
void glide_details_c(const struct pass_call *call);
void glide_interleave_c(const struct pass_call *call);
void glide_point_c(const struct pass_call *call);
void glide_bilinear_c(const struct pass_call *call);
void glide_bilinear_8_c(const struct pass_call *call);
void glide_bilinear_565_c(const struct pass_call *call);
void glide_store_565_c(const struct pass_call *call);
void glide_widen_565_c(const struct pass_call *call);
void glide_tile_16_c(const struct pass_call *call);
void glide_tile_32_c(const struct pass_call *call);
void glide_lerp_c(const struct pass_call *call);
void glide_scale_c(const struct pass_call *call);
void glide_modulate_c(const struct pass_call *call);
void glide_modulate_rgb_c(const struct pass_call *call);
void glide_add_c(const struct pass_call *call);
void glide_alpha_c(const struct pass_call *call);
void glide_combiner_c(const struct pass_call *call);

/* A line through the combine unit: glide_combining_find and glide_combine_line. */
struct glide_combine_call {
    struct glide_modes modes;
    const uint32 *other;
    const uint8 *details, *fractions;
    int32 detail_step, fraction_step;
    int32 detail, fraction, flip;       /* as struct glide_known */
    uint8 odd;                  /* the level is */
    uint8 has_other, has_alpha, spare;
};

/* Of the local texels in. Without has_alpha alpha becomes 0. */
void glide_combine_line_c(const struct pass_call *call);

/* glide_logarithms_make of the limits in. */
void glide_logarithms_c(const struct pass_call *call);

/* glide_quads_make, glide_quads_8_make of the two rows in, one behind the other. */
void glide_quads_c(const struct pass_call *call);
void glide_quads_8_c(const struct pass_call *call);

#endif
