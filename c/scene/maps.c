/* What maps that are copied and maps that are read have in common. */
#include "scene/maps.h"

#include "scene/load.h"
#include "system/system.h"

void scene_copy(uint8 *to, const uint8 *from, uint32 bytes)
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

void scene_margins_fill(uint8 *texels)
{
    scene_copy(texels - HALF_PAGE, texels + HALF_PAGE, HALF_PAGE);
    scene_copy(texels + PAGE_BYTES, texels, HALF_PAGE);
}

uint32 scene_map_bytes(const struct scene_texture *t)
{
    if (t->layout == MAP_PAGE)
        return PAGE_BYTES * t->texel_bytes;
    if (t->layout == MAP_MARGINS)
        return 2 * PAGE_BYTES;
    return ((uint32)(t->width * t->height) * t->texel_bytes + 3) & ~(uint32)3;
}

enum map_order scene_map_order(const struct scene_texture *t)
{
    static const uint8 order[MAP_LAYOUTS] = {
        [MAP_PAGE] = ORDER_PAGES, [MAP_TILED] = ORDER_PAGES, [MAP_MARGINS] = ORDER_MARGINS,
        [MAP_LIGHT] = ORDER_LIGHT, [MAP_LINEAR] = ORDER_ANYWHERE, [MAP_COLUMNS] = ORDER_ANYWHERE
    };

    if (t->texel_bytes > 1)
        return ORDER_ANYWHERE;
    if (t->layout == MAP_LINEAR && t->width == MAP_PAGE_SIDE && t->height == MAP_PAGE_SIDE)
        return ORDER_PAGES;
    return (enum map_order)order[t->layout];
}

void scene_judge_light(struct map *map)
{
    const uint8 *dark = map->texels, *full = dark + 256 * (LIGHT_LEVELS - 1);

    map->full = map->dark = 1;
    for (int32 i = 0; i < 256; i++) {
        map->full &= full[i] == i;
        map->dark &= dark[i] == dark[0];
    }
}

/* All rows are in one block. */
int32 scene_make_rows(struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_material *m = scene->materials;
    struct map_row *rows;
    int32 height = 0;

    for (uint32 i = 0; i < h->materials; i++)
        if (m[i].mapper == MAPPER_KEYED)
            height += scene->maps[m[i].texture].height;
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

/* Copies a texture to its memory and sets the map. */
static void copy_map(struct map *map, const struct scene_texture *t, const uint8 *from, uint8 *memory)
{
    const int32 bytes = (int32)t->texel_bytes;

    scene_map_place(map, t, memory);
    if (t->layout == MAP_PAGE) {
        scene_page_fill(memory, from, t->width * bytes, t->height, MAP_PAGE_SIDE * bytes,
                        bytes > 1 ? MAP_PAGE_SIDE / 2 : 0);
        return;
    }
    scene_copy((uint8 *)map->texels, from, (uint32)(t->width * t->height) * t->texel_bytes);
    if (t->layout == MAP_MARGINS)
        scene_margins_fill((uint8 *)map->texels);
    else if (t->layout == MAP_LIGHT)
        scene_judge_light(map);
}

/* All maps are in one block. */
int32 scene_copy_maps(struct scene *scene, int32 kind)
{
    uint32 count = scene->header->textures, bytes = 0, align = 4, gap = 0;
    uint8 *at;

    if (!mem_alloc(&scene->maps, (int32)(count * sizeof *scene->maps), MEMORY_ANY))
        return 0;
    if (!count)
        return 1;
    for (uint32 i = 0; i < count; i++) {
        const struct scene_texture *t = &scene->textures[i];
        enum map_order order = scene_map_order(t);

        if (order != ORDER_ANYWHERE)
            align = PAGE_BYTES;
        if (order == ORDER_MARGINS)
            gap = HALF_PAGE;
        bytes += scene_map_bytes(t);
    }
    if (!mem_alloc(&at, (int32)(bytes + align + gap), kind))
        return 0;
    at += (0 - (uint32)at) & (align - 1);
    for (uint32 order = 0; order <= ORDER_ANYWHERE; order++) {
        if (order == ORDER_MARGINS)
            at += gap;
        for (uint32 i = 0; i < count; i++) {
            const struct scene_texture *t = &scene->textures[i];

            if (scene_map_order(t) != order)
                continue;
            copy_map(&scene->maps[i], t, (const uint8 *)scene->header + t->at, at);
            at += scene_map_bytes(t);
        }
    }
    return 1;
}
