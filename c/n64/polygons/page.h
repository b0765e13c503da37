/* A tile as the plain mappers read it: a page of 256x256 combined pixels in the frame's format.
   Only rows that polygons need are made. */
#ifndef N64_PAGE_H
#define N64_PAGE_H

#include "n64/polygons/lower.h"

/* The part of an axis that a page shows: column or row k has relative index first + k, for k from
   least to least + 255. An axis that repeats within the page has no end; one that clamps ends with
   the page. */
struct n64_window {
    int32 least;                /* columns: 0, rows: -64 */
    int32 first;                /* texels */
    int32 period;               /* texels; 0: it clamps */
};

/* Finds the windows of a tile's page; returns 0 if no page can show the tile. Tiles with a shift
   have none. */
int32 n64_page_windows(const struct n64_tile *tile, int32 copy, struct n64_window *columns,
                       struct n64_window *rows);

/* Makes rows of the unit's page from its first tile, unless they are valid already. Their pixels
   are combined from texel 0 and constants; in copy mode they are the texels. Returns 0 if there is
   no memory or if a page cannot show all that copy mode reads. */
int32 n64_page_make(struct n64_unit *unit, const struct n64_needs *needs, int32 pixel_bytes,
                    const struct page_rows *rows, uint32 *room);

#endif
