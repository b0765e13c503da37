#include "bench/kernels.h"

#include "plain/glide.h"
#include "plain/n64.h"
#include "plain/screen.h"
#include "polygon/kind.h"
#include "span/scanline.h"
#include "system/text.h"
#include "texture/map.h"

/* column_layout_make as a kernel: its arguments come from a plan, its result goes to count. */
static void make_columns(struct span_plan *plan)
{
    plan->count = column_layout_make((struct column_layout *)plan->columns, plan->map_width,
                                     plan->map_height);
}

static void nothing(void)
{
}

#define PASS(name) {#name, (void (*)(void))name}

/* Kernels in C, and an empty one, whose time is the cost of a call. */
static const struct kernel c_kernels[] = {
    {"span_affine_c", (void (*)(void))span_affine_c},
    {"column_layout_make", (void (*)(void))make_columns},
    {"nothing", nothing},
    PASS(n64_reciprocals_c), PASS(n64_levels_c), PASS(n64_matrix_c),
    PASS(glide_quads_c), PASS(glide_quads_8_c), PASS(glide_logarithms_c), PASS(glide_products_c),
    PASS(glide_combine_line_c),
    PASS(c2p_8_c), PASS(c2p_8_2x1_c), PASS(c2p_ham8_16_c), PASS(c2p_ham8_5551_c),
    PASS(c2p_ham8_32_c), PASS(ham8_control),
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
