/* Forms of combining, found from the combiner's codes, and the combiner over a line. */
#ifndef N64_FORMS_H
#define N64_FORMS_H

#include "n64/pixel.h"
#include "n64/polygons/scratch.h"

/* The two parts of a form: the texel, a blend or the product of both, then an operation on it. */
enum n64_first { N64_FIRST_TEXEL, N64_FIRST_BLEND, N64_FIRST_PRODUCT };
enum n64_second {
    N64_SECOND_NOTHING,
    N64_SECOND_TABLES,          /* each channel by its own table: the rest is constant */
    N64_SECOND_MODULATE         /* times shade */
};

struct n64_form {
    uint8 any;                  /* 1: no special form: run the combiner's cycles */
    uint8 first, second;
    uint8 cycle;                /* the second part is this cycle's */
    uint8 swapped;              /* texel 1 alone, or a blend from it to texel 0 */
    int16 fraction;             /* of a blend by a constant; -1: by the level's */
};

void n64_form_find(struct n64_form *form, const struct n64 *n64);

/* Where the inputs of the combiner are: one a pixel, or (step 0) a constant. */
struct n64_places {
    const struct n64_wide *combined, *texel0, *texel1, *shade;
    int32 shade_step;
    const int16 *fraction;      /* the level's */
    int32 fraction_step;
};

/* Both cycles of the combiner: constants and, for each channel, what it reads. */
struct n64_combiner_plan {
    struct n64_wide primitive, environment, shade;
    int16 singles[6];           /* N64_ONE to N64_K5; the level's fraction is not there */
    struct n64_combination of[2][4];
};

/* Finds the constants, except shade's. */
void n64_combiner_begin(struct n64_combiner_plan *plan, const struct n64 *n64);

/* Finds what the channels of a cycle read. */
void n64_combiner_find(struct n64_combiner_plan *plan, const struct n64 *n64,
                       const struct n64_places *at, int32 cycle);

/* Returns non-zero if a cycle's result is this source (of colour and of alpha), unchanged. */
int32 n64_form_is_input(const struct n64 *n64, int32 cycle, uint32 source);

/* Runs one cycle of the combiner over pixels. */
void n64_combine_cycle(const struct n64 *n64, const struct n64_places *at, int32 cycle,
                       struct n64_wide *results, int32 count);

#endif
