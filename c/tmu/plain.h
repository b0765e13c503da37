/* The passes in plain C: the yardsticks of the bench. */
#ifndef TMU_PLAIN_H
#define TMU_PLAIN_H

#include "tmu/passes.h"
#include "tx/plain.h"

void tmu_walk_c(const struct tx_call *call);
void tmu_walk_clamp_c(const struct tx_call *call);
void tmu_divide_c(const struct tx_call *call);
void tmu_lod_c(const struct tx_call *call);
void tmu_point_c(const struct tx_call *call);
void tmu_bilinear_c(const struct tx_call *call);
void tmu_bilinear_565_c(const struct tx_call *call);
void tmu_store_565_c(const struct tx_call *call);
void tmu_lerp_c(const struct tx_call *call);
void tmu_scale_c(const struct tx_call *call);
void tmu_modulate_c(const struct tx_call *call);
void tmu_add_c(const struct tx_call *call);
void tmu_combiner_c(const struct tx_call *call);

/* tmu_logarithms_make of the limits in. */
void tmu_logarithms_c(const struct tx_call *call);

/* tmu_quad_make of the four texels in, R G B A. */
void tmu_quads_c(const struct tx_call *call);

#endif
