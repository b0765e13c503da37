/* Finds the cheapest way to draw a unit's polygon with the same picture. */
#ifndef N64_LOWER_H
#define N64_LOWER_H

#include "n64/polygons/unit.h"
#include "polygon/setup.h"

/* Inputs of a polygon that change from pixel to pixel, and the constant values of the others. */
struct n64_needs {
    uint32 inputs;
    struct n64_colour shade;    /* if inputs lacks N64_INPUT_SHADE */
    int32 divided;              /* s and t are divided by w */
};

void n64_lower_inputs(struct n64_needs *needs, struct setup *s, const struct n64 *n64,
                      const uint32 *colours);

/* Returns non-zero if the plain mappers can draw the polygon from a page. Makes the page and its
   material, and sets *vertices to the vertices relative to the page. */
int32 n64_lower_to_plain(const struct n64_needs *needs, struct setup *s, struct n64_unit *unit,
                         const struct vertex **vertices);

/* Draws a triangle from the page, whose state is that of the polygon before; its coordinates are in range.
   Returns enum polygon_result, or -1: it must be lowered. */
int32 n64_page_again(struct n64_unit *unit, struct renderer *renderer, const struct vertex *given);

/* page.c. Finds the parts of s and t that a tile's page shows: from column 0 and row -64 on. An
   axis that repeats within the page has no end; one that clamps ends with the page. Returns 0 if no
   page can show the tile. Tiles with a shift have none. */
int32 n64_page_windows(const struct n64_tile *tile, int32 copy, struct page_window *columns,
                       struct page_window *rows);

/* page.c. Makes rows of the unit's page from its first tile, unless they are valid already. Their
   pixels are combined from texel 0 and constants; in copy mode they are the texels. Returns 0 if there is
   no memory or if a page cannot show all that copy mode reads. */
int32 n64_page_make(struct n64_unit *unit, const struct n64_needs *needs, int32 pixel_bytes,
                    const struct page_rows *rows, uint32 *room);

#endif
