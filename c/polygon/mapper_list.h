/* The list of mappers: the tables in C are made from it, and tools read it. */
#ifndef MAPPER_LIST_H
#define MAPPER_LIST_H

#include "compiler.h"

/* MAPPER(kind, name, layout, bytes, is, span, span_16, span_32):
   layout: of its map; MAP_LAYOUTS: it has none;
   bytes: sizes of the pixels it can draw, 1 + 2 + 4;
   is: enum mapper_trait;
   span, span_16, span_32: the general kind of span for 1, 2 and 4 bytes a pixel. */
#define MAPPER_LIST(MAPPER) \
    MAPPER(FLAT, flat, MAP_LAYOUTS, 1 + 2 + 4, 0, SPAN_FILL, SPAN_FILL_16, SPAN_FILL_32) \
    /* shade is the pixel */ \
    MAPPER(GOURAUD, gouraud, MAP_LAYOUTS, 1, MAPPER_BY_VERTICES, SPAN_GOURAUD, 0, 0) \
    MAPPER(AFFINE, affine, MAP_PAGE, 1 + 2 + 4, MAPPER_PERSPECTIVE, \
           SPAN_AFFINE_ADDX_WRAP, SPAN_AFFINE_16_WRAP, SPAN_AFFINE_32_WRAP) \
    /* s, t inside a map of any size */ \
    MAPPER(ARBITRARY, arbitrary, MAP_LINEAR, 1, 0, SPAN_ARBITRARY, 0, 0) \
    MAPPER(TILED, tiled, MAP_TILED, 1, 0, SPAN_TILED, 0, 0) \
    MAPPER(COLUMNS, columns, MAP_COLUMNS, 1 + 2, 0, SPAN_COLUMNS, SPAN_COLUMNS_16, 0) \
    /* code generated for the polygon's steps; affine spans if u of a line leaves its row */ \
    MAPPER(GENERATED, generated, MAP_MARGINS, 1, MAPPER_BY_VERTICES, SPAN_GENERATED, 0, 0) \
    /* through a light table, at the level of the first vertex */ \
    MAPPER(LIT, lit, MAP_PAGE, 1, MAPPER_LIGHTS + MAPPER_BY_VERTICES + MAPPER_PERSPECTIVE, \
           SPAN_LIT_WRAP, 0, 0) \
    /* each pixel at its level */ \
    MAPPER(LIT_GOURAUD, lit_gouraud, MAP_PAGE, 1, \
           MAPPER_LIGHTS + MAPPER_PLANE + MAPPER_BY_VERTICES + MAPPER_PERSPECTIVE, \
           SPAN_LIT_GOURAUD, 0, 0) \
    /* as affine, sample points moved by up to 3/8 texel: see span_dithered */ \
    MAPPER(DITHERED, dithered, MAP_PAGE, 1 + 2 + 4, MAPPER_PLANE, \
           SPAN_DITHERED_WRAP, SPAN_DITHERED_16_WRAP, SPAN_DITHERED_32_WRAP) \
    /* as affine, without the pixels whose texel is 0 */ \
    MAPPER(KEYED, keyed, MAP_PAGE, 1, MAPPER_PLANE, SPAN_KEYED_WRAP, 0, 0) \
    /* drawn by the material's texture unit or Glide pipe, not by polygon_draw */ \
    MAPPER(N64, n64, MAP_LAYOUTS, 2 + 4, MAPPER_UNIT, 0, 0, 0) \
    MAPPER(GLIDE, glide, MAP_LAYOUTS, 2 + 4, MAPPER_UNIT, 0, 0, 0)

#endif
