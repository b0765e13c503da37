/* The passes in plain C: the yardsticks of the bench. */
#ifndef PLAIN_N64_H
#define PLAIN_N64_H

#include "plain/call.h"
#include "tx/passes.h"

void tx_walk_c(const struct pass_call *call);
void tx_threepoint_c(const struct pass_call *call);
void tx_threepoint_16_c(const struct pass_call *call);
void tx_average_c(const struct pass_call *call);
void tx_point_c(const struct pass_call *call);
void tx_store_16_c(const struct pass_call *call);
void tx_divide_c(const struct pass_call *call);
void tx_tile_c(const struct pass_call *call);
void tx_lerp_c(const struct pass_call *call);
void tx_shade_c(const struct pass_call *call);
void tx_modulate_c(const struct pass_call *call);
void tx_map_c(const struct pass_call *call);
void tx_widen_c(const struct pass_call *call);
void tx_combiner_c(const struct pass_call *call);
void tx_narrow_c(const struct pass_call *call);
void tx_lod_c(const struct pass_call *call);
void tx_chroma_c(const struct pass_call *call);
void tx_convert_c(const struct pass_call *call);
void tx_convert_wide_c(const struct pass_call *call);
void tx_quads_c(const struct pass_call *call);

/* tx_divide_table_make. */
void tx_reciprocals_c(const struct pass_call *call);

/* tx_matrix_make of the numbers in. */
void tx_matrix_c(const struct pass_call *call);

/* tx_levels_make of the modes that the constants are. */
void tx_levels_c(const struct pass_call *call);

#endif
