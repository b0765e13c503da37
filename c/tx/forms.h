/* What the combiner's codes come to. */
#ifndef TX_FORMS_H
#define TX_FORMS_H

#include "tx/pixel.h"

enum { TX_LINE_PIXELS = 256 };  /* that the passes draw at a time */

/* What is made of the texels, and then of that. */
enum tx_first { TX_FIRST_TEXEL, TX_FIRST_BLEND };
enum tx_second {
    TX_SECOND_NOTHING,
    TX_SECOND_TABLES,           /* each channel a function of its own, the rest constants */
    TX_SECOND_MODULATE          /* times shade */
};

struct tx_form {
    uint8 any;                  /* 1: none of these: the cycles as they stand */
    uint8 first, second;
    uint8 cycle;                /* whose codes the second part is */
    uint8 swapped;              /* texel 1 alone, or a blend of it towards texel 0 */
    int16 fraction;             /* a blend by a constant; -1: by the level's */
};

void tx_form_find(struct tx_form *form, const struct tx *tx);

/* Where the inputs of the combiner are: from pixel to pixel, or (step 0) constants. */
struct tx_places {
    const struct tx_wide *combined, *texel0, *texel1, *shade;
    int32 shade_step;
    const int16 *fraction;      /* the level's */
    int32 fraction_step;
};

/* One cycle over pixels, as its codes stand. */
void tx_combine_cycle(const struct tx *tx, const struct tx_places *at, int32 cycle,
                      struct tx_wide *results, int32 count);

/* All cycles: combined is not looked at. results: room for two lines. */
void tx_combine_line(const struct tx *tx, const struct tx_places *at,
                     struct tx_wide (*results)[TX_LINE_PIXELS], uint32 *colours, int32 count);

#endif
