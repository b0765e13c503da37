/* A map that a texture unit's polygons are drawn from by the plain mappers: a page of 256x256
   pixels of the frame, MAP_PAGE. Rows are made as polygons show them. */
#ifndef PAGE_H
#define PAGE_H

#include "polygon/key.h"
#include "polygon/setup.h"

enum page_constants {
    PAGE_MARGIN = 1,            /* texels: more than u and v of a pixel leave the vertices' range */
    /* Polygons have their middle at row 64: small ones leave neither rows 0 to 127, which lie one
       behind the other, nor those that there is memory for. */
    PAGE_MIDDLE = 64,
    PAGE_LEAST_ROW = PAGE_MIDDLE - MAP_PAGE_SIDE / 2
};

struct page {
    struct map map;
    uint8 *texels;              /* memory for it, */
    int32 bytes, half;          /* how much, and for how many rows on either side of the middle */
    int32 from, end;            /* rows that are made: from to end - 1, of 256 */
};

/* Which part of an axis a page shows, s or t of the vertices in 16.16 and a texel of the page
   1.0. */
struct page_window {
    fix16 origin;               /* column or row 0 */
    int32 least;                /* the first one: of columns 0, of rows PAGE_LEAST_ROW */
    fix16 period;               /* it repeats, 256 being a multiple; 0: it ends with the page */
};

struct page_rows {
    int32 first, last;
};

/* Makes row v of a page whose rows from to end - 1 are made: it lies beside them. */
typedef void page_row_maker(void *context, int32 v, int32 from, int32 end);

void page_init(struct page *page);

/* None of its rows is right any more. */
void page_forget(struct page *page);

/* Whether rows are made. */
int32 page_has(const struct page *page, const struct page_rows *rows);

/* Memory for rows, and the map, for pixels of so many bytes; where memory is new no row is made.
   What was taken before stays taken until the program ends. 0: there is none. */
int32 page_ready(struct page *page, int32 pixel_bytes, int32 memory,
                 const struct page_rows *rows);

/* Makes the rows that are not yet, from the made ones on. */
void page_grow(struct page *page, const struct page_rows *rows, page_row_maker *make,
               void *context);

/* Where row v lies. */
uint8 *page_row(const struct page *page, int32 v);

/* Whether the pixels of a polygon lie within the window; value: s or t of its first vertex. */
int32 page_is_within(const struct setup *s, const fix16 *value, const struct page_window *window);

/* The vertices relative to the page, moved by whole periods: so that they are around its middle,
   and spans do not leave it where they need not. shown: rows that their pixels may show. */
const struct vertex *page_vertices(const struct setup *s, const struct page_window *columns,
                                   const struct page_window *rows, struct page_rows *shown);

/* What draws them: s and t are planes to the last bit. */
void page_material(struct material *plain, const struct material *from, const struct page *page);

#endif
