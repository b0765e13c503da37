/* A tile as the plain mappers read it: combined pixels of the frame on a page of 256x256, of
   which the rows are made that polygons need. */
#ifndef N64_PAGE_H
#define N64_PAGE_H

#include "n64/polygons/lower.h"

/* What an axis' page shows: column or row k is relative index first + k, for 256 of them from
   least on. An axis that repeats within a page goes on for ever, one that clamps ends with the
   page. */
struct n64_window {
    int32 least;                /* of columns 0, of rows -64 */
    int32 first;                /* texels */
    int32 period;               /* texels; 0: it clamps */
};

/* Whether a page can stand for a tile at all, and where. Shifted ones have none. */
int32 n64_page_windows(const struct n64_tile *tile, int32 copy, struct n64_window *columns,
                       struct n64_window *rows);

/* Makes rows of the unit's page fit its first tile, their colours being
   what the combiner makes of texel 0 and constants, or in copy mode the texels; nothing is done
   where they still do. 0: there is no memory, or copy mode reads more than a page has. */
int32 n64_page_make(struct n64_unit *unit, const struct n64_needs *needs, int32 pixel_bytes,
                    const struct page_rows *rows, uint32 *room);

#endif
