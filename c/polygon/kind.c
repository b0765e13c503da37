#include "polygon/kind.h"

const struct kind_routines kind_routines[SPAN_KINDS] = {
    [SPAN_FILL] = {edge_flat, edge_flat_exact, scissor_flat, span_fill},
    [SPAN_FILL_16] = {edge_flat, edge_flat_exact, scissor_flat, span_fill_16},
    [SPAN_AFFINE_ADDX] = {edge_addx, edge_addx_exact, scissor_addx, span_affine_addx},
    [SPAN_AFFINE_ADDX_WRAP] = {edge_addx, edge_addx_exact, scissor_addx,
                               span_affine_addx_wrap},
    [SPAN_AFFINE_ROW] = {edge_addx, edge_addx_exact, scissor_addx, span_affine_row},
    [SPAN_AFFINE_COLUMN] = {edge_addx, edge_addx_exact, scissor_addx, span_affine_column},
    [SPAN_AFFINE_SCANLINE] = {edge_flat, edge_flat_exact, scissor_flat,
                              span_affine_scanline},
    [SPAN_AFFINE_SWAP] = {edge_swap, edge_plain_exact, scissor_plain, span_affine_swap},
    [SPAN_AFFINE_C] = {edge_swap, edge_plain_exact, scissor_plain, span_affine_c},
    [SPAN_GOURAUD] = {edge_plain, edge_plain_exact, scissor_plain, span_gouraud},
    [SPAN_ARBITRARY] = {edge_plain, edge_plain_exact, scissor_plain, span_arbitrary},
    [SPAN_TILED] = {edge_plain, edge_plain_exact, scissor_plain, span_tiled},
    [SPAN_COLUMNS] = {edge_plain, edge_plain_exact, scissor_plain, span_columns},
    [SPAN_COLUMNS_16] = {edge_plain, edge_plain_exact, scissor_plain, span_columns_16},
    [SPAN_GENERATED] = {edge_plain, edge_plain_exact, scissor_plain, span_generated},
    [SPAN_LIT] = {edge_addx, edge_addx_exact, scissor_addx, span_lit},
    [SPAN_LIT_WRAP] = {edge_addx, edge_addx_exact, scissor_addx, span_lit_wrap},
    [SPAN_LIT_GOURAUD] = {edge_addx, edge_addx_exact, scissor_addx, span_lit_gouraud}
};
