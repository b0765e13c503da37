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
    [SPAN_LIT_GOURAUD] = {edge_addx, edge_addx_exact, scissor_addx, span_lit_gouraud},
    [SPAN_AFFINE_COPY] = {edge_addx, edge_addx_exact, scissor_addx, span_affine_copy},
    [SPAN_AFFINE_SHORT] = {edge_addx, edge_addx_exact, scissor_addx, span_affine_short},
    [SPAN_AFFINE_SHORT_WRAP] = {edge_addx, edge_addx_exact, scissor_addx,
                                span_affine_short_wrap},
    [SPAN_AFFINE_ROW_SHORT] = {edge_addx, edge_addx_exact, scissor_addx,
                               span_affine_row_short},
    [SPAN_GOURAUD_SHORT] = {edge_plain, edge_plain_exact, scissor_plain, span_gouraud_short},
    [SPAN_LIT_SHORT] = {edge_addx, edge_addx_exact, scissor_addx, span_lit_short},
    [SPAN_LIT_SHORT_WRAP] = {edge_addx, edge_addx_exact, scissor_addx, span_lit_short_wrap}
};

/* Whether a step is 0, and whether one is small enough for the spans that step u or v
   alone: 62 texels a pixel, for 1,024 pixels. Both as the map repeats, modulo 256. */
static int32 is_still(fix16 step)
{
    return !((uint32)step << 8);
}

static int32 is_slow(fix16 step)
{
    const uint32 most = (uint32)62 << 24;

    return ((uint32)step << 8) + most <= 2 * most;
}

/* The addx chain, or a part of it where the polygon needs no more. */
static enum span_kind addx_kind(const struct texturing *t)
{
    if (is_still(t->dvdx) && is_slow(t->dudx))
        return SPAN_AFFINE_ROW;
    if (is_still(t->dudx) && is_slow(t->dvdx))
        return SPAN_AFFINE_COLUMN;
    return t->wraps ? SPAN_AFFINE_ADDX_WRAP : SPAN_AFFINE_ADDX;
}

static enum span_kind affine_kind(enum gradients gradients, enum form form,
                                  const struct texturing *t)
{
    return gradients == GRADIENTS_SCANLINE ? SPAN_AFFINE_SCANLINE
         : form == FORM_SWAP ? SPAN_AFFINE_SWAP
         : form == FORM_C ? SPAN_AFFINE_C
         : addx_kind(t);
}

enum span_kind kind_of(const struct material *material, const struct frame *frame,
                       enum form form, const struct texturing *texturing)
{
    /* Where the mapper decides: with 1 and 2 bytes a pixel. */
    static const uint8 kinds[MAPPER_KINDS][2] = {
        [MAPPER_FLAT] = {SPAN_FILL, SPAN_FILL_16},
        [MAPPER_GOURAUD] = {SPAN_GOURAUD},
        [MAPPER_ARBITRARY] = {SPAN_ARBITRARY},
        [MAPPER_TILED] = {SPAN_TILED},
        [MAPPER_COLUMNS] = {SPAN_COLUMNS, SPAN_COLUMNS_16},
        [MAPPER_GENERATED] = {SPAN_GENERATED},
        [MAPPER_LIT_GOURAUD] = {SPAN_LIT_GOURAUD}
    };
    enum gradients gradients = material->gradients;

    if (material->mapper == MAPPER_AFFINE)
        return affine_kind(gradients, form, texturing);
    if (material->mapper == MAPPER_LIT)
        return gradients == GRADIENTS_SCANLINE || texturing->wraps ? SPAN_LIT_WRAP : SPAN_LIT;
    return kinds[material->mapper][frame->pixel_bytes - 1];
}
