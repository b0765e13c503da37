/* The passes in plain C: the yardsticks of the bench. */
#ifndef PLAIN_N64_H
#define PLAIN_N64_H

#include "plain/call.h"
#include "n64/passes.h"

void n64_walk_c(const struct pass_call *call);
void n64_threepoint_c(const struct pass_call *call);
void n64_threepoint_16_c(const struct pass_call *call);
void n64_average_c(const struct pass_call *call);
void n64_point_c(const struct pass_call *call);
void n64_store_16_c(const struct pass_call *call);
void n64_divide_c(const struct pass_call *call);
void n64_tile_c(const struct pass_call *call);
void n64_lerp_c(const struct pass_call *call);
void n64_shade_c(const struct pass_call *call);
void n64_modulate_c(const struct pass_call *call);
void n64_map_c(const struct pass_call *call);
void n64_widen_c(const struct pass_call *call);
void n64_combiner_c(const struct pass_call *call);
void n64_narrow_c(const struct pass_call *call);
void n64_lod_c(const struct pass_call *call);
void n64_chroma_c(const struct pass_call *call);
void n64_convert_c(const struct pass_call *call);
void n64_convert_wide_c(const struct pass_call *call);
void n64_quads_c(const struct pass_call *call);

/* n64_divide_table_make. */
void n64_reciprocals_c(const struct pass_call *call);

/* n64_matrix_make of the numbers in. */
void n64_matrix_c(const struct pass_call *call);

/* n64_levels_make of the modes that the constants are. */
void n64_levels_c(const struct pass_call *call);

#endif
