/* The least that gives a unit's polygon the same picture. */
#ifndef TX_LOWER_H
#define TX_LOWER_H

#include "polygon/setup.h"
#include "tx/unit.h"

/* A polygon's colours where they are the same at all pixels, and what remains of
   tx->inputs. */
struct tx_needs {
    uint32 inputs;
    struct tx_colour shade;     /* where TX_INPUT_SHADE is not among inputs */
    int32 divided;              /* s and t are divided by w */
};

void tx_lower_inputs(struct tx_needs *needs, struct setup *s, const struct tx *tx,
                     const uint32 *colours);

/* Whether the pixel is the same everywhere. */
int32 tx_lower_to_flat(const struct tx_needs *needs, struct setup *s);

/* Whether the plain mappers draw it: a page that stands for the tile, the material for them in
   *plain; *vertices are those relative to the tile. */
int32 tx_lower_to_plain(const struct tx_needs *needs, struct setup *s, struct tx_unit *unit,
                        struct material *plain, const struct vertex **vertices);

#endif
