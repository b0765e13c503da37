/* A map from which plain mappers draw a texture unit's polygons: a MAP_PAGE of 256x256 pixels in
   the frame's format. Rows are made when polygons first show them. */
#ifndef PAGE_H
#define PAGE_H

#include "drawing/three.h"

enum page_constants {
    PAGE_MARGIN = 1,            /* texels: u, v of a pixel leave the vertices' range by less */
    /* Polygons have their middle at row 64: small ones stay in rows 0 to 127, which are contiguous,
       and in the rows that have memory. */
    PAGE_MIDDLE = 64,
    PAGE_LEAST_ROW = PAGE_MIDDLE - MAP_PAGE_SIDE / 2,
    PAGE_KEY = 10               /* longs of a page's cache key, at most */
};

/* All 0 before the first use. */
struct page {
    struct map map;
    uint8 *texels;              /* memory of the rows */
    int32 bytes, half;          /* its size; the rows it has on either side of the middle */
    int32 from, end;            /* rows that are made: from to end - 1, of 256 */
    uint32 key[PAGE_KEY];       /* cache key of these rows */
    struct material plain;      /* page_material */
    const struct material *of;  /* the unit's, whose triangles `three` draws; or null */
    struct three three;
};

/* The part of the s or t axis that a page shows, in 16.16; a texel of the page is 1.0. */
struct page_window {
    fix16 origin;               /* column or row 0 */
    int32 least;                /* the first column, 0, or row, PAGE_LEAST_ROW */
    fix16 period;               /* of repetition, a divisor of 256; 0: it ends with the page */
};

struct page_rows {
    int32 first, last;
};

/* Makes row v of a page. Rows from to end - 1 are made already, and v is next to them. */
typedef void page_row_maker(void *context, int32 v, int32 from, int32 end);

/* Returns non-zero if the rows are made. With another cache key than before none is. */
int32 page_has(struct page *page, const uint32 *key, int32 words, const struct page_rows *rows);

/* Provides memory for rows and sets the map, for pixels of pixel_bytes bytes. In new memory no row
   is made; the old memory is not freed before the program ends. Returns 0 if memory is short. */
int32 page_ready(struct page *page, int32 pixel_bytes, int32 memory,
                 const struct page_rows *rows);

/* Makes the missing rows, outwards from those already made. */
void page_grow(struct page *page, const struct page_rows *rows, page_row_maker *make,
               void *context);

/* Returns the address of row v. */
uint8 *page_row(const struct page *page, int32 v);

/* Writes pixel x of a row of 2 or 4 bytes a pixel. */
static inline void pixel_write(uint8 *row, int32 x, int32 pixel_bytes, uint32 pixel)
{
    if (pixel_bytes == 4)
        ((uint32 *)row)[x] = pixel;
    else
        ((uint16 *)row)[x] = (uint16)pixel;
}

/* Returns 1 if all pixels of a polygon are within the window; value: s or t of its first vertex. */
int32 page_is_within(const fix16 *value, int32 count, const struct page_window *window);

/* Sets x, y, s and t of a polygon's vertices relative to the page. With a period they are moved by whole
   periods to the page's middle, so that spans stay inside if possible. Sets *shown to the rows that their
   pixels may show. Returns `to`. */
const struct vertex *page_vertices(struct vertex *to, const struct vertex *given, int32 count,
                                   const struct page_window *columns, const struct page_window *rows,
                                   struct page_rows *shown);

/* Sets page->plain to the material that draws from the page: s and t are planes to the last bit. */
void page_material(struct page *page, const struct material *from);

/* Draws the polygon of a unit's setup with these vertices, as polygon_draw, but without a setup of its own. */
enum polygon_result page_draw(struct setup *s, const struct vertex *vertices, struct page *page);

/* Returns non-zero if page_again draws a triangle of the unit's material: its first vertex is inside the frame,
   page_draw has drawn another one, and neither renderer nor material have changed. */
int32 page_is_same(const struct page *page, const struct renderer *renderer, const struct polygon *polygon,
                   const struct material *material);

/* Draws a triangle with these vertices from rows that are made. */
enum polygon_result page_again(struct page *page, const struct renderer *renderer, const struct vertex *vertices);

/* Provides memory for `count` elements of `size` bytes of cached data, of which *has elements are
   there: *address is the pointer to them. Memory is kept for the next time. Returns 0 if it is
   short. */
int32 page_room(void *address, uint32 *has, uint32 count, uint32 size);

#endif
