/* The tables of span routines, mappers and lines by the parts that a program names: parts.h includes it. A kind that
   is not named is drawn by the more general one, or else flat. */
#ifndef DRAWING_SPANS_H
#define DRAWING_SPANS_H

#include "drawing/parts/named.h"
#include "polygon/kind.h"

/* HAS_n: 1 if the mapper is named. WRAP_n: what draws where v may wrap. */
#ifdef WITH_FLAT
#define HAS_FLAT 1
#else
#define HAS_FLAT 0
#endif
#define PART_FILL span_fill

#ifdef WITH_GOURAUD
#define HAS_GOURAUD 1
#define PART_GOURAUD span_gouraud
#else
#define HAS_GOURAUD 0
#define PART_GOURAUD span_fill
#endif

#ifdef WITH_AFFINE
#define HAS_AFFINE 1
#define PART_AFFINE_ADDX span_affine_addx
#define PART_AFFINE_ADDX_WRAP span_affine_addx_wrap
#else
#define HAS_AFFINE 0
#define PART_AFFINE_ADDX span_fill
#define PART_AFFINE_ADDX_WRAP span_fill
#endif

#ifdef WITH_ARBITRARY
#define HAS_ARBITRARY 1
#define PART_ARBITRARY span_arbitrary
#else
#define HAS_ARBITRARY 0
#define PART_ARBITRARY span_fill
#endif

#ifdef WITH_TILED
#define HAS_TILED 1
#define PART_TILED span_tiled
#else
#define HAS_TILED 0
#define PART_TILED span_fill
#endif

#ifdef WITH_COLUMNS
#define HAS_COLUMNS 1
#define PART_COLUMNS span_columns
#else
#define HAS_COLUMNS 0
#define PART_COLUMNS span_fill
#endif

#ifdef WITH_GENERATED
#define HAS_GENERATED 1
#define PART_GENERATED span_generated
#else
#define HAS_GENERATED 0
#define PART_GENERATED span_fill
#endif

#ifdef WITH_LIT
#define HAS_LIT 1
#define PART_LIT span_lit
#define PART_LIT_WRAP span_lit_wrap
#else
#define HAS_LIT 0
#define PART_LIT span_fill
#define PART_LIT_WRAP span_fill
#endif

#ifdef WITH_LIT_GOURAUD
#define HAS_LIT_GOURAUD 1
#define PART_LIT_GOURAUD span_lit_gouraud
#else
#define HAS_LIT_GOURAUD 0
#define PART_LIT_GOURAUD span_fill
#endif

#ifdef WITH_DITHERED
#define HAS_DITHERED 1
#define PART_DITHERED span_dithered
#define PART_DITHERED_WRAP span_dithered_wrap
#else
#define HAS_DITHERED 0
#define PART_DITHERED span_fill
#define PART_DITHERED_WRAP span_fill
#endif

#ifdef WITH_KEYED
#define HAS_KEYED 1
#define PART_KEYED span_keyed
#define PART_KEYED_WRAP span_keyed_wrap
#else
#define HAS_KEYED 0
#define PART_KEYED span_fill
#define PART_KEYED_WRAP span_fill
#endif

/* By polygon_draw's neighbours, not by it. */
#define HAS_N64 1
#define HAS_GLIDE 1

/* Rows, columns and copies. */
#if defined(WITH_ROWS) && defined(WITH_AFFINE)
#define PART_AFFINE_ROW span_affine_row
#define PART_AFFINE_COLUMN span_affine_column
#define PART_AFFINE_COPY span_affine_copy
#else
#define PART_AFFINE_ROW PART_AFFINE_ADDX_WRAP
#define PART_AFFINE_COLUMN PART_AFFINE_ADDX_WRAP
#define PART_AFFINE_COPY PART_AFFINE_ADDX_WRAP
#endif

#if defined(WITH_ROWS) && defined(WITH_KEYED)
#define PART_KEYED_ROW span_keyed_row
#define PART_KEYED_ROWS span_keyed_rows
#else
#define PART_KEYED_ROW PART_KEYED_WRAP
#define PART_KEYED_ROWS PART_KEYED_WRAP
#endif

/* Unrolled code for short lines. */
#if defined(WITH_SHORT) && defined(WITH_AFFINE)
#define PART_AFFINE_SHORT span_affine_short
#define PART_AFFINE_SHORT_WRAP span_affine_short_wrap
#else
#define PART_AFFINE_SHORT PART_AFFINE_ADDX
#define PART_AFFINE_SHORT_WRAP PART_AFFINE_ADDX_WRAP
#endif

#if defined(WITH_SHORT) && defined(WITH_ROWS) && defined(WITH_AFFINE)
#define PART_AFFINE_ROW_SHORT span_affine_row_short
#else
#define PART_AFFINE_ROW_SHORT PART_AFFINE_ROW
#endif

#if defined(WITH_SHORT) && defined(WITH_GOURAUD)
#define PART_GOURAUD_SHORT span_gouraud_short
#else
#define PART_GOURAUD_SHORT PART_GOURAUD
#endif

#if defined(WITH_SHORT) && defined(WITH_LIT)
#define PART_LIT_SHORT span_lit_short
#define PART_LIT_SHORT_WRAP span_lit_short_wrap
#else
#define PART_LIT_SHORT PART_LIT
#define PART_LIT_SHORT_WRAP PART_LIT_WRAP
#endif

/* Lines with two divides, and light over lines in perspective. */
#ifdef WITH_SCANLINE
#define PART_AFFINE_SCANLINE span_affine_scanline
#else
#define PART_AFFINE_SCANLINE span_fill
#endif

#ifdef WITH_FORMS
#define PART_AFFINE_SWAP span_affine_swap
#define PART_AFFINE_C span_affine_c
#else
#define PART_AFFINE_SWAP span_fill
#define PART_AFFINE_C span_fill
#endif

#if defined(WITH_PERSPECTIVE) && defined(WITH_LIT)
#define PART_LIGHT span_light
#else
#define PART_LIGHT span_fill
#endif

#if defined(WITH_PERSPECTIVE) && defined(WITH_LIT_GOURAUD)
#define PART_LIGHT_GOURAUD span_light_gouraud
#else
#define PART_LIGHT_GOURAUD span_fill
#endif

/* Larger pixels. */
#ifdef WITH_16
#define HAS_16 PART_16
#define PART_FILL_16 span_fill_16
#else
#define HAS_16 0
#define PART_FILL_16 span_fill
#endif

#if defined(WITH_16) && defined(WITH_AFFINE)
#define PART_AFFINE_16 span_affine_16
#define PART_AFFINE_16_WRAP span_affine_16_wrap
#else
#define PART_AFFINE_16 span_fill
#define PART_AFFINE_16_WRAP span_fill
#endif

#if defined(WITH_16) && defined(WITH_AFFINE) && defined(WITH_ROWS)
#define PART_AFFINE_16_ROW span_affine_16_row
#define PART_AFFINE_16_COPY span_affine_16_copy
#else
#define PART_AFFINE_16_ROW PART_AFFINE_16_WRAP
#define PART_AFFINE_16_COPY PART_AFFINE_16_WRAP
#endif

#if defined(WITH_16) && defined(WITH_COLUMNS)
#define PART_COLUMNS_16 span_columns_16
#else
#define PART_COLUMNS_16 span_fill
#endif

#if defined(WITH_16) && defined(WITH_DITHERED)
#define PART_DITHERED_16 span_dithered_16
#define PART_DITHERED_16_WRAP span_dithered_16_wrap
#else
#define PART_DITHERED_16 span_fill
#define PART_DITHERED_16_WRAP span_fill
#endif

#ifdef WITH_32
#define HAS_32 PART_32
#define PART_FILL_32 span_fill_32
#else
#define HAS_32 0
#define PART_FILL_32 span_fill
#endif

#if defined(WITH_32) && defined(WITH_AFFINE)
#define PART_AFFINE_32 span_affine_32
#define PART_AFFINE_32_WRAP span_affine_32_wrap
#else
#define PART_AFFINE_32 span_fill
#define PART_AFFINE_32_WRAP span_fill
#endif

#if defined(WITH_32) && defined(WITH_AFFINE) && defined(WITH_ROWS)
#define PART_AFFINE_32_ROW span_affine_32_row
#else
#define PART_AFFINE_32_ROW PART_AFFINE_32_WRAP
#endif

#if defined(WITH_32) && defined(WITH_DITHERED)
#define PART_DITHERED_32 span_dithered_32
#define PART_DITHERED_32_WRAP span_dithered_32_wrap
#else
#define PART_DITHERED_32 span_fill
#define PART_DITHERED_32_WRAP span_fill
#endif

/* Lines. */
#if defined(WITH_AFFINE) || defined(WITH_DITHERED) || defined(WITH_KEYED)
#define PART_LINES_ADDX {edge_addx, edge_addx_exact, {lines_addx, lines_addx_exact}, scissor_addx}
#else
#define PART_LINES_ADDX PART_LINES_FLAT
#endif

#if defined(WITH_GOURAUD) || defined(WITH_ARBITRARY) || defined(WITH_TILED) || defined(WITH_COLUMNS) \
    || defined(WITH_GENERATED)
#define PART_LINES_PLAIN {edge_plain, edge_plain_exact, {lines_plain, lines_plain_exact}, scissor_plain}
#else
#define PART_LINES_PLAIN PART_LINES_FLAT
#endif

#ifdef WITH_FORMS
#define PART_LINES_SWAP {edge_swap, edge_plain_exact, {0, 0}, scissor_plain}
#else
#define PART_LINES_SWAP PART_LINES_FLAT
#endif

#define PART_LINES_FLAT {edge_flat, edge_flat_exact, {lines_flat, lines_flat_exact}, scissor_flat}

const struct line_routines line_routines[LINE_FORMS] = {
    PART_LINES_FLAT, PART_LINES_ADDX, PART_LINES_SWAP, PART_LINES_PLAIN
};

/* Settings. */
#ifdef WITH_STARTS
#define HAS_STARTS PART_STARTS
#else
#define HAS_STARTS 0
#endif

#ifdef WITH_SCANLINE
#define HAS_SCANLINE PART_SCANLINE
#else
#define HAS_SCANLINE 0
#endif

#ifdef WITH_CLIPPING
#define HAS_CLIPPING PART_CLIPPING
#else
#define HAS_CLIPPING 0
#endif

#ifdef WITH_PERSPECTIVE
#define HAS_PERSPECTIVE PART_PERSPECTIVE
#else
#define HAS_PERSPECTIVE 0
#endif

#ifdef WITH_CURVES
#define HAS_CURVES PART_CURVES
#define PART_PIXEL PERSPECTIVE_PIXEL
#define PART_FINE PERSPECTIVE_FINE
#else
#define HAS_CURVES 0
#define PART_PIXEL PERSPECTIVE_EVERY8
#define PART_FINE PERSPECTIVE_EVERY8
#endif

const uint8 perspective_named[PERSPECTIVE_ROOM] = {
    PERSPECTIVE_NONE, PERSPECTIVE_EVERY16, PERSPECTIVE_EVERY8, PART_PIXEL, PART_FINE
};

const uint32 drawing_parts = HAS_16 + HAS_32 + HAS_STARTS + HAS_SCANLINE + HAS_CLIPPING + HAS_PERSPECTIVE
    + HAS_CURVES
#define MAPPER(kind, name, layout, bytes, is, span, span_16, span_32) \
    + ((uint32)HAS_##kind << MAPPER_##kind)
    MAPPER_LIST(MAPPER)
#undef MAPPER
    ;

/* The sizes of pixels. */
#define PART_BYTES (1 + (HAS_16 ? 2 : 0) + (HAS_32 ? 4 : 0))

/* Lines in perspective: frames of pixels that are not named are refused before. */
#ifdef WITH_PERSPECTIVE
#ifdef WITH_16
#define PART_PIECES_16 span_perspective_pieces_16
#define PART_CURVES_16 span_perspective_curves_16
#define PART_SCANLINE_16 span_affine_16_scanline
#define PART_LEVEL_16 span_affine_16_level
#else
#define PART_PIECES_16 0
#define PART_CURVES_16 0
#define PART_SCANLINE_16 0
#define PART_LEVEL_16 0
#endif

#ifdef WITH_32
#define PART_PIECES_32 span_perspective_pieces_32
#define PART_CURVES_32 span_perspective_curves_32
#define PART_SCANLINE_32 span_affine_32_scanline
#define PART_LEVEL_32 span_affine_32_level
#else
#define PART_PIECES_32 0
#define PART_CURVES_32 0
#define PART_SCANLINE_32 0
#define PART_LEVEL_32 0
#endif

perspective_routine *const perspective_pieces[3] = {span_perspective_pieces, PART_PIECES_16, PART_PIECES_32};
span_routine *const perspective_scanlines[2][3] = {
    {span_affine_scanline, PART_SCANLINE_16, PART_SCANLINE_32}, {span_affine_level, PART_LEVEL_16, PART_LEVEL_32}
};
#ifdef WITH_CURVES
perspective_routine *const perspective_curves[3] = {span_perspective_curves, PART_CURVES_16, PART_CURVES_32};
#else
perspective_routine *const perspective_curves[3] = {0, 0, 0};
#endif
#endif

enum { NO_LAYOUT = 255 };       /* of no map: set_map refuses it */

const struct mapper_traits mappers[MAPPER_KINDS] = {
#define MAPPER(kind, name, layout, bytes, is, span, span_16, span_32) \
    {HAS_##kind ? (int)layout : (int)NO_LAYOUT, HAS_##kind ? (bytes) & PART_BYTES : 0, is, {span, span_16, span_32}, {0, 0}},
    MAPPER_LIST(MAPPER)
#undef MAPPER
};

span_routine *const kind_spans[SPAN_KINDS] = {
#define SPAN(kind, name, lines) PART_##kind,
#define OTHER(kind, name) 0,
    SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER
};

const uint8 kind_lines[SPAN_KINDS] = {
#define SPAN(kind, name, lines) LINES_##lines,
#define OTHER(kind, name) 0,
    SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER
};

#endif
