/* Lists of the kinds of spans and of the rules that lower one to a cheaper one. Enums, names,
   routines and tables are made from these lists; Python has the enums. */
#ifndef SPAN_LIST_H
#define SPAN_LIST_H

#include "compiler.h"

/* SPAN(kind, name, lines): span_<name> draws the table of lines that LINES_<lines> describes.
   OTHER(kind, name): something else draws, and counts, it. Flat ones come first. */
#define SPAN_LIST(SPAN, OTHER) \
    SPAN(FILL, fill, FLAT) \
    SPAN(FILL_16, fill_16, FLAT) \
    SPAN(FILL_32, fill_32, FLAT) \
    SPAN(GOURAUD, gouraud, PLAIN) \
    SPAN(AFFINE_ADDX, affine_addx, ADDX) \
    SPAN(AFFINE_ADDX_WRAP, affine_addx_wrap, ADDX) \
    SPAN(AFFINE_ROW, affine_row, ADDX) \
    SPAN(AFFINE_COLUMN, affine_column, ADDX) \
    SPAN(AFFINE_SCANLINE, affine_scanline, FLAT) \
    SPAN(AFFINE_SWAP, affine_swap, SWAP) \
    SPAN(AFFINE_C, affine_c, SWAP) \
    SPAN(ARBITRARY, arbitrary, PLAIN) \
    SPAN(TILED, tiled, PLAIN) \
    SPAN(COLUMNS, columns, PLAIN) \
    SPAN(COLUMNS_16, columns_16, PLAIN) \
    SPAN(GENERATED, generated, PLAIN) \
    SPAN(LIT, lit, ADDX) \
    SPAN(LIT_WRAP, lit_wrap, ADDX) \
    SPAN(LIT_GOURAUD, lit_gouraud, ADDX) \
    OTHER(AFFINE_UPRIGHT, affine_upright) \
    OTHER(PERSPECTIVE_PIECES, perspective_pieces) \
    OTHER(PERSPECTIVE_CURVES, perspective_curves) \
    OTHER(RECIPROCAL, reciprocal) \
    OTHER(CUBIC, cubic) \
    SPAN(LIGHT, light, FLAT) \
    SPAN(LIGHT_GOURAUD, light_gouraud, FLAT) \
    SPAN(AFFINE_COPY, affine_copy, ADDX) \
    SPAN(AFFINE_SHORT, affine_short, ADDX) \
    SPAN(AFFINE_SHORT_WRAP, affine_short_wrap, ADDX) \
    SPAN(AFFINE_ROW_SHORT, affine_row_short, ADDX) \
    SPAN(GOURAUD_SHORT, gouraud_short, PLAIN) \
    SPAN(LIT_SHORT, lit_short, ADDX) \
    SPAN(LIT_SHORT_WRAP, lit_short_wrap, ADDX) \
    SPAN(AFFINE_16, affine_16, ADDX) \
    SPAN(AFFINE_16_WRAP, affine_16_wrap, ADDX) \
    SPAN(AFFINE_16_ROW, affine_16_row, ADDX) \
    SPAN(AFFINE_16_COPY, affine_16_copy, ADDX) \
    SPAN(AFFINE_32, affine_32, ADDX) \
    SPAN(AFFINE_32_WRAP, affine_32_wrap, ADDX) \
    SPAN(AFFINE_32_ROW, affine_32_row, ADDX) \
    SPAN(DITHERED, dithered, ADDX) \
    SPAN(DITHERED_WRAP, dithered_wrap, ADDX) \
    SPAN(DITHERED_16, dithered_16, ADDX) \
    SPAN(DITHERED_16_WRAP, dithered_16_wrap, ADDX) \
    SPAN(DITHERED_32, dithered_32, ADDX) \
    SPAN(DITHERED_32_WRAP, dithered_32_wrap, ADDX) \
    SPAN(KEYED, keyed, ADDX) \
    SPAN(KEYED_WRAP, keyed_wrap, ADDX) \
    SPAN(KEYED_ROW, keyed_row, ADDX) \
    SPAN(KEYED_ROWS, keyed_rows, ADDX) \
    OTHER(TRIANGLES_FLAT, triangles_flat) \
    OTHER(TRIANGLES_GOURAUD, triangles_gouraud) \
    OTHER(TRIANGLES_AFFINE, triangles_affine) \
    OTHER(N64_PASSES, n64_passes) \
    OTHER(N64_PIXELS, n64_pixels) \
    OTHER(GLIDE_PASSES, glide_passes) \
    OTHER(GLIDE_PIXELS, glide_pixels) \
    OTHER(GLIDE_TILES, glide_tiles)

/* RULE(rule, name): why a polygon is drawn in a cheaper way than its material's. They are
   in c/drawing/lower.c and c/drawing/parts, and those of texture units in c/n64 and c/glide. */
#define RULE_LIST(RULE) \
    RULE(OUTSIDE, outside)                 /* outside the frame: nothing is drawn */ \
    RULE(EQUAL_SHADES, equal_shades)       /* all vertices have the same pixel: flat */ \
    RULE(EQUAL_LEVELS, equal_levels)       /* one level of light: no interpolation */ \
    RULE(NO_LIGHT, no_light)               /* the light makes all texels the same: flat */ \
    RULE(FULL_LIGHT, full_light)           /* the light changes no texel: no light */ \
    RULE(CONSTANT_W, constant_w)           /* all vertices have the same depth: affine */ \
    RULE(TOLERANCE, tolerance)             /* affine is within the material's tolerance */ \
    RULE(COARSER, coarser)                 /* longer subspans, or affine lines, are within it */ \
    RULE(INSIDE_FRAME, inside_frame)       /* no line is cut to the frame's columns */ \
    RULE(INSIDE_RANGE, inside_range)       /* u, v, shade stay in their range */ \
    RULE(STILL_V, still_v)                 /* v does not change along lines */ \
    RULE(UNIT_STEP, unit_step)             /* also, u moves a texel a pixel: lines are copied */ \
    RULE(STILL_U, still_u)                 /* u does not change along lines */ \
    RULE(NO_WRAP, no_wrap)                 /* v wraps once in a line at most */ \
    RULE(NO_WRAP_LIT, no_wrap_lit)         /* the same with light */ \
    RULE(NO_WRAP_DITHERED, no_wrap_dithered) /* the same for v moved by dithering */ \
    RULE(STILL_V_KEYED, still_v_keyed)     /* STILL_V, NO_WRAP where texels may be transparent */ \
    RULE(OPAQUE_ROWS, opaque_rows)         /* also, transparent ends of rows are left out */ \
    RULE(NO_WRAP_KEYED, no_wrap_keyed) \
    RULE(SHORT, short)                     /* unrolled code for all pixels fits the cache */ \
    RULE(SHORT_WRAP, short_wrap) \
    RULE(SHORT_ROW, short_row) \
    RULE(SHORT_GOURAUD, short_gouraud) \
    RULE(SHORT_LIT, short_lit) \
    RULE(SHORT_LIT_WRAP, short_lit_wrap) \
    RULE(N64_FLAT, n64_flat)               /* no texel affects the combiner's result: flat */ \
    RULE(N64_PLAIN, n64_plain)             /* point samples of one tile: an affine span */ \
    RULE(N64_PASSES, n64_passes)           /* passes over lines: not pixel by pixel */ \
    RULE(GLIDE_PLAIN, glide_plain)         /* point samples of one level: an affine span */ \
    RULE(GLIDE_PASSES, glide_passes)       /* as N64_PASSES */ \
    RULE(GLIDE_TILES, glide_tiles)         /* one LOD, no divide: from prefiltered tiles */

#endif
