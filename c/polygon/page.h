/* A map that a texture unit's polygons are drawn from by the plain mappers: a page of 256x256
   pixels of the frame, MAP_PAGE. */
#ifndef PAGE_H
#define PAGE_H

#include "polygon/setup.h"

enum page_constants {
    PAGE_MARGIN = 1             /* texels: more than u and v of a pixel leave the vertices' range */
};

/* Which part of an axis a page shows, s or t of the vertices in 16.16 and a texel of the page
   1.0. */
struct page_window {
    fix16 origin;               /* of column or row 0 */
    fix16 period;               /* it repeats, 256 being a multiple; 0: it ends with the page */
    int32 least;                /* the page's first column or row */
};

/* Whether the pixels of a polygon lie within the window; value: s or t of its first vertex. */
int32 page_is_within(const struct setup *s, const fix16 *value, const struct page_window *window);

/* The window's origin, moved by whole periods: so that the vertices are around the page's middle,
   and spans do not leave it where they need not. */
fix16 page_origin(const struct setup *s, const fix16 *value, const struct page_window *window);

/* The vertices relative to origins. */
const struct vertex *page_vertices(const struct setup *s, fix16 s_origin, fix16 t_origin);

/* What a page is made of, but for its texels; what draws from it: s and t are planes to the last
   bit. */
void page_map(struct map *map, int32 pixel_bytes);
void page_material(struct material *plain, const struct material *from, const struct map *map);

#endif
