/* A tile as the plain mappers read it: combined pixels of the frame on a page of 256x256. */
#ifndef TX_PAGE_H
#define TX_PAGE_H

#include "tx/unit.h"

/* What an axis' page shows: column k is relative index first + k. An axis that repeats within a
   page goes on for ever, one that clamps ends with the page. */
struct tx_window {
    int32 first;                /* texels */
    int32 period;               /* texels; 0: it clamps */
};

/* Whether a page can stand for an axis at all, and where. Shifted axes have none. */
int32 tx_page_window(const struct tx_axis *axis, int32 copy, struct tx_window *window);

/* Makes the unit's page fit a tile, its colour being what the combiner makes of texel 0 and
   constants, or in copy mode the texel; nothing is done where it still does. 0: there is no
   memory, or copy mode reads more than a page has. */
int32 tx_page_make(struct tx_unit *unit, int32 tile, int32 pixel_bytes,
                   const struct tx_colour *shade);

#endif
