/* The passes in plain C: the yardsticks of the bench. */
#ifndef PLAIN_GLIDE_H
#define PLAIN_GLIDE_H

#include "plain/call.h"
#include "tmu/passes.h"
#include "tmu/tmu.h"

void tmu_walk_c(const struct pass_call *call);
void tmu_walk_clamp_c(const struct pass_call *call);
void tmu_divide_c(const struct pass_call *call);
void tmu_pieces_c(const struct pass_call *call);
void tmu_lod_c(const struct pass_call *call);
void tmu_details_c(const struct pass_call *call);
void tmu_interleave_c(const struct pass_call *call);
void tmu_point_c(const struct pass_call *call);
void tmu_bilinear_c(const struct pass_call *call);
void tmu_bilinear_8_c(const struct pass_call *call);
void tmu_bilinear_565_c(const struct pass_call *call);
void tmu_store_565_c(const struct pass_call *call);
void tmu_widen_565_c(const struct pass_call *call);
void tmu_tile_16_c(const struct pass_call *call);
void tmu_tile_32_c(const struct pass_call *call);
void tmu_lerp_c(const struct pass_call *call);
void tmu_scale_c(const struct pass_call *call);
void tmu_modulate_c(const struct pass_call *call);
void tmu_modulate_rgb_c(const struct pass_call *call);
void tmu_add_c(const struct pass_call *call);
void tmu_alpha_c(const struct pass_call *call);
void tmu_combiner_c(const struct pass_call *call);

/* A line through the combine unit: tmu_combining_find and tmu_combine_line. */
struct tmu_combine_call {
    struct tmu_modes modes;
    const uint32 *other;
    const uint8 *details, *fractions;
    int32 detail_step, fraction_step;
    int32 detail, fraction, flip;       /* as struct tmu_known */
    uint8 odd;                  /* the level is */
    uint8 has_other, has_alpha, spare;
};

/* Of the local texels in. Without has_alpha alpha becomes 0. */
void tmu_combine_line_c(const struct pass_call *call);

/* tmu_logarithms_make of the limits in. */
void tmu_logarithms_c(const struct pass_call *call);

/* tmu_quads_make, tmu_quads_8_make of the two rows in, one behind the other. */
void tmu_quads_c(const struct pass_call *call);
void tmu_quads_8_c(const struct pass_call *call);

#endif
