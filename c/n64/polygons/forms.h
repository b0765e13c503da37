/* What the combiner's codes come to. */
#ifndef N64_FORMS_H
#define N64_FORMS_H

#include "n64/pixel.h"
#include "n64/polygons/scratch.h"

/* What is made of the texels, and then of that. */
enum n64_first { N64_FIRST_TEXEL, N64_FIRST_BLEND };
enum n64_second {
    N64_SECOND_NOTHING,
    N64_SECOND_TABLES,          /* each channel a function of its own, the rest constants */
    N64_SECOND_MODULATE         /* times shade */
};

struct n64_form {
    uint8 any;                  /* 1: none of these: the cycles as they stand */
    uint8 first, second;
    uint8 cycle;                /* whose codes the second part is */
    uint8 swapped;              /* texel 1 alone, or a blend of it towards texel 0 */
    int16 fraction;             /* a blend by a constant; -1: by the level's */
};

void n64_form_find(struct n64_form *form, const struct n64 *n64);

/* Where the inputs of the combiner are: from pixel to pixel, or (step 0) constants. */
struct n64_places {
    const struct n64_wide *combined, *texel0, *texel1, *shade;
    int32 shade_step;
    const int16 *fraction;      /* the level's */
    int32 fraction_step;
};

/* One cycle over pixels, as its codes stand. */
void n64_combine_cycle(const struct n64 *n64, const struct n64_places *at, int32 cycle,
                       struct n64_wide *results, int32 count);

/* All cycles: combined is not looked at. results: room for two lines. */
void n64_combine_line(const struct n64 *n64, const struct n64_places *at,
                      struct n64_wide (*results)[N64_LINE_PIXELS], uint32 *colours, int32 count);

#endif
