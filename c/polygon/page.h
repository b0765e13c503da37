/* A map that a texture unit's polygons are drawn from by the plain mappers: a page of 256x256
   pixels of the frame, MAP_PAGE. */
#ifndef PAGE_H
#define PAGE_H

#include "polygon/setup.h"

enum page_constants {
    PAGE_MARGIN = 1             /* texels: more than u and v of a pixel leave the vertices' range */
};

struct page {
    struct map map;
    uint8 *texels;              /* memory for it, */
    int32 bytes;                /* and how much */
};

/* Which part of an axis a page shows, s or t of the vertices in 16.16 and a texel of the page
   1.0. */
struct page_window {
    fix16 origin;               /* where it begins */
    fix16 period;               /* it repeats, 256 being a multiple; 0: it ends with the page */
};

/* Memory for a page, its map for pixels of so many bytes. Row 0 lies at map.texels, rows 128 to
   255 before it. 0: there is none. */
int32 page_ready(struct page *page, int32 pixel_bytes, int32 memory);

/* Whether the pixels of a polygon lie within the window; value: s or t of its first vertex. */
int32 page_is_within(const struct setup *s, const fix16 *value, const struct page_window *window);

/* The vertices relative to the page, moved by whole periods: so that they are around its middle,
   and spans do not leave it where they need not. */
const struct vertex *page_vertices(const struct setup *s, const struct page_window *columns,
                                   const struct page_window *rows);

/* What draws them: s and t are planes to the last bit. */
void page_material(struct material *plain, const struct material *from, const struct page *page);

#endif
