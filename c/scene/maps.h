/* What copying maps and reading maps have in common: maps.c. */
#ifndef MAPS_H
#define MAPS_H

#include "scene/scene.h"

enum map_bytes {
    PAGE_BYTES = MAP_PAGE_SIDE * MAP_PAGE_SIDE,
    HALF_PAGE = PAGE_BYTES / 2,
    LIGHT_BYTES = MAP_PAGE_SIDE * LIGHT_LEVELS
};

/* Copies bytes; both addresses are multiples of 4. */
void scene_copy(uint8 *to, const uint8 *from, uint32 bytes);

/* Returns the bytes of a texture in memory, rounded up to a multiple of 4. */
uint32 scene_map_bytes(const struct scene_texture *texture);

/* Returns a texture's place in the order of maps. */
enum map_order {
    ORDER_PAGES,                /* begin at multiples of 65,536 */
    ORDER_MARGINS,              /* half a page after such a multiple */
    ORDER_LIGHT,                /* inside a page */
    ORDER_ANYWHERE              /* at multiples of 4 */
};
enum map_order scene_map_order(const struct scene_texture *texture);

/* Sets a map whose memory begins at `memory`. */
static inline void scene_map_place(struct map *map, const struct scene_texture *t, uint8 *memory)
{
    map->texels = memory;
    if (t->layout == MAP_MARGINS)
        map->texels += HALF_PAGE;
    else if (t->layout == MAP_PAGE && t->texel_bytes > 1)
        map->texels += HALF_PAGE * t->texel_bytes;
    map->width = t->width;
    map->height = t->height;
    map->scale = map_scale(t->width, t->height);
    map->layout = (uint8)t->layout;
    map->texel_bytes = (uint8)t->texel_bytes;
    map->full = map->dark = 0;
    map->rows = 0;
}

/* Repeats a map over a page: `row`, `width`: bytes of a row of the page and of the map; `top`: the page's
   first row. The map's sides are powers of two, and it is at least a longword wide. It may be in the last
   bytes of the page if top is 0. */
static inline void scene_page_fill(uint8 *page, const uint8 *from, int32 width, int32 height, int32 row, int32 top)
{
    for (int32 v = top; v < top + MAP_PAGE_SIDE; v++)
        for (int32 u = 0; u < row; u += width, page += width)
            scene_copy(page, from + (v & (height - 1)) * width, (uint32)width);
}

/* Makes the copies before and after a map with margins. */
void scene_margins_fill(uint8 *texels);

/* Sets full and dark of a light table, which lowering reads. */
void scene_judge_light(struct map *map);

/* Makes the rows of maps with transparent texels; returns 0 if memory is short. */
int32 scene_make_rows(struct scene *scene);

#endif
