#include "bench/kernels.h"

#include "plain/glide.h"
#include "plain/n64.h"
#include "plain/screen.h"
#include "span/logarithm.h"
#include "span/scanline.h"
#include "system/text.h"
#include "texture/map.h"

/* column_layout_make as a kernel: its arguments are in a plan, the result in count. */
static void make_columns(struct span_plan *plan)
{
    plan->count = column_layout_make((struct column_layout *)plan->columns, plan->map_width,
                                     plan->map_height);
}

/* logarithms_make as a kernel: the tables name the memory. */
static void make_logarithms(struct logarithm_tables *tables)
{
    logarithms_make(tables, (int16 *)tables->logs, (uint16 *)tables->powers);
}

static void nothing(void)
{
}

#define PASS(name) {#name, (void (*)(void))name}

/* Beside the assembly: what is written in C, and what costs nothing. */
static const struct kernel c_kernels[] = {
    {"span_affine_c", (void (*)(void))span_affine_c},
    {"column_layout_make", (void (*)(void))make_columns},
    {"logarithms_make", (void (*)(void))make_logarithms},
    {"nothing", nothing},
    PASS(tx_walk_c), PASS(tx_threepoint_c), PASS(tx_average_c),
    PASS(tx_point_c), PASS(tx_store_16_c),
    PASS(tx_divide_c), PASS(tx_tile_c), PASS(tx_lerp_c),
    PASS(tx_quads_c), PASS(tx_reciprocals_c),
    PASS(tx_modulate_c), PASS(tx_map_c), PASS(tx_widen_c),
    PASS(tx_combiner_c), PASS(tx_narrow_c), PASS(tx_lod_c), PASS(tx_levels_c),
    PASS(tx_threepoint_16_c), PASS(tx_shade_c), PASS(tx_chroma_c),
    PASS(tx_convert_c), PASS(tx_convert_wide_c), PASS(tx_matrix_c),
    PASS(tmu_walk_c), PASS(tmu_walk_clamp_c), PASS(tmu_point_c), PASS(tmu_bilinear_c),
    PASS(tmu_bilinear_565_c), PASS(tmu_store_565_c), PASS(tmu_quads_c),
    PASS(tmu_widen_565_c),
    PASS(tmu_lerp_c), PASS(tmu_scale_c), PASS(tmu_modulate_c), PASS(tmu_add_c),
    PASS(tmu_combiner_c), PASS(tmu_divide_c), PASS(tmu_lod_c), PASS(tmu_logarithms_c),
    PASS(tmu_alpha_c), PASS(tmu_bilinear_8_c),
    PASS(tmu_quads_8_c), PASS(tmu_modulate_rgb_c), PASS(tmu_combine_line_c),
    PASS(tmu_details_c), PASS(tmu_interleave_c), PASS(tmu_pieces_c),
    PASS(c2p_8_c), PASS(c2p_ham8_16_c), PASS(c2p_ham8_5551_c),
    PASS(c2p_ham8_32_c), PASS(ham8_control),
    PASS(tmu_tile_16_c), PASS(tmu_tile_32_c),
    {0, 0}
};

static void (*find(const struct kernel *kernel, const char *name))(void)
{
    while (kernel->name && !text_same(kernel->name, name))
        kernel++;
    return kernel->routine;
}

void (*kernel_find(const char *name))(void)
{
    void (*routine)(void) = find(kernel_table, name);

    return routine ? routine : find(c_kernels, name);
}
