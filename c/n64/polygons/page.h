/* A tile as the plain mappers read it: a page of 256x256 combined pixels in the frame's format.
   Only rows that polygons need are made. */
#ifndef N64_PAGE_H
#define N64_PAGE_H

#include "n64/polygons/lower.h"

/* Finds the parts of s and t that a tile's page shows: from column 0 and row -64 on. An axis that
   repeats within the page has no end; one that clamps ends with the page. Returns 0 if no page can
   show the tile. Tiles with a shift have none. */
int32 n64_page_windows(const struct n64_tile *tile, int32 copy, struct page_window *columns,
                       struct page_window *rows);

/* Makes rows of the unit's page from its first tile, unless they are valid already. Their pixels
   are combined from texel 0 and constants; in copy mode they are the texels. Returns 0 if there is
   no memory or if a page cannot show all that copy mode reads. */
int32 n64_page_make(struct n64_unit *unit, const struct n64_needs *needs, int32 pixel_bytes,
                    const struct page_rows *rows, uint32 *room);

#endif
