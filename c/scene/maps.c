/* Copies textures from the scene file to the memory that mappers read. */
#include "scene/scene.h"

#include "system/system.h"

enum map_memory {
    PAGE_BYTES = MAP_PAGE_SIDE * MAP_PAGE_SIDE,
    HALF_PAGE = PAGE_BYTES / 2,
    ORDER_MARGINS = 2,
    ORDER_ANYWHERE = 4,
    BYTES_MAX = 0x40000000      /* far more than any machine has; sums stay inside 32 bits */
};

static void copy(uint8 *to, const uint8 *from, uint32 bytes)
{
    uint32 *to_long = (uint32 *)to;
    const uint32 *from_long = (const uint32 *)from;

    for (; bytes >= 4; bytes -= 4)
        *to_long++ = *from_long++;
    to = (uint8 *)to_long;
    from = (const uint8 *)from_long;
    while (bytes--)
        *to++ = *from++;
}

/* Repeats a map over a page whose first row is `top`. The map's sides are powers of two, and it is
   at least a longword wide. width, row: bytes of a row of the map and of the page. */
static void make_page(uint8 *page, const uint8 *from, int32 width, int32 height, int32 row,
                      int32 top)
{
    for (int32 v = top; v < top + MAP_PAGE_SIDE; v++)
        for (int32 u = 0; u < row; u += width, page += width)
            copy(page, from + (v & (height - 1)) * width, (uint32)width);
}

/* Returns the bytes of a texture in memory, rounded up to a multiple of 4. */
static uint32 map_bytes(const struct scene_texture *t)
{
    if (t->layout == MAP_PAGE)
        return PAGE_BYTES * t->texel_bytes;
    if (t->layout == MAP_MARGINS)
        return 2 * PAGE_BYTES;
    return ((uint32)(t->width * t->height) * t->texel_bytes + 3) & ~(uint32)3;
}

/* Sets full and dark of a light table, which lowering reads. */
static void judge_light(struct map *map)
{
    const uint8 *dark = map->texels, *full = dark + 256 * (LIGHT_LEVELS - 1);

    map->full = map->dark = 1;
    for (int32 i = 0; i < 256; i++) {
        map->full &= full[i] == i;
        map->dark &= dark[i] == dark[0];
    }
}

/* Copies a texture to its memory, which begins at texels, and sets the map. */
static void make_map(struct map *map, const struct scene_texture *t, const uint8 *from,
                     uint8 *texels)
{
    int32 bytes = (int32)t->texel_bytes, row = MAP_PAGE_SIDE * bytes;
    int32 top = bytes > 1 ? MAP_PAGE_SIDE / 2 : 0;

    if (t->layout == MAP_PAGE) {
        make_page(texels, from, t->width * bytes, t->height, row, top);
        texels += top * row;
    } else if (t->layout == MAP_MARGINS) {
        copy(texels, from + HALF_PAGE, HALF_PAGE);
        texels += HALF_PAGE;
        copy(texels, from, PAGE_BYTES);
        copy(texels + PAGE_BYTES, from, HALF_PAGE);
    } else {
        copy(texels, from, (uint32)(t->width * t->height) * t->texel_bytes);
    }
    map->texels = texels;
    map->width = t->width;
    map->height = t->height;
    map->scale = map_scale(t->width, t->height);
    map->layout = (uint8)t->layout;
    map->texel_bytes = (uint8)t->texel_bytes;
    map->full = map->dark = 0;
    map->rows = 0;
    if (t->layout == MAP_LIGHT)
        judge_light(map);
}

/* Returns a texture's place in the order of maps. Pages and what is like them begin at multiples of
   65,536; maps with margins half a page after such a multiple; then come light tables, each of which
   is inside a page, and the others. */
static uint32 order_of(const struct scene_texture *t)
{
    static const uint8 order[MAP_LAYOUTS] = {
        [MAP_PAGE] = 0, [MAP_TILED] = 1, [MAP_MARGINS] = ORDER_MARGINS, [MAP_LIGHT] = 3,
        [MAP_LINEAR] = 4, [MAP_COLUMNS] = 5
    };

    if (t->layout == MAP_LINEAR && t->width == MAP_PAGE_SIDE && t->height == MAP_PAGE_SIDE)
        return 0;
    return order[t->layout];
}

/* Makes the rows of maps with transparent texels, in one block. */
static int32 make_rows(struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_material *m = scene->materials;
    struct map_row *rows;
    int32 height = 0;

    for (uint32 i = 0; i < h->materials; i++)
        if (m[i].mapper == MAPPER_KEYED)
            height += scene->maps[m[i].texture].height;
    if (!height)
        return 1;
    if (!mem_alloc(&rows, height * (int32)sizeof *rows, MEMORY_ANY))
        return 0;
    for (uint32 i = 0; i < h->materials; i++) {
        struct map *map = &scene->maps[m[i].texture];

        if (m[i].mapper != MAPPER_KEYED || map->rows)
            continue;
        map_rows_make(rows, map);
        map->rows = rows;
        rows += map->height;
    }
    return 1;
}

/* All maps are in one block. */
int32 scene_make_maps(struct scene *scene, int32 kind)
{
    uint32 count = scene->header->textures, bytes = 0, align = 4, gap = 0;
    uint8 *at;

    if (!mem_alloc(&scene->maps, (int32)(count * sizeof *scene->maps), MEMORY_ANY))
        return 0;
    if (!count)
        return 1;
    for (uint32 i = 0; i < count; i++) {
        const struct scene_texture *t = &scene->textures[i];

        if (t->texel_bytes == 1 && order_of(t) < ORDER_ANYWHERE)
            align = PAGE_BYTES;
        if (t->layout == MAP_MARGINS)
            gap = HALF_PAGE;
        bytes += map_bytes(t);
        if (bytes > BYTES_MAX)
            return 0;
    }
    if (!mem_alloc(&at, (int32)(bytes + align + gap), kind))
        return 0;
    at += (0 - (uint32)at) & (align - 1);
    for (uint32 k = 0; k < MAP_LAYOUTS; k++) {
        if (k == ORDER_MARGINS)
            at += gap;
        for (uint32 i = 0; i < count; i++) {
            const struct scene_texture *t = &scene->textures[i];

            if (order_of(t) != k)
                continue;
            make_map(&scene->maps[i], t, (const uint8 *)scene->header + t->at, at);
            at += map_bytes(t);
        }
    }
    return make_rows(scene);
}
