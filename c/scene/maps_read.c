/* Reads textures from the scene file straight to the memory that mappers read. */
#include "scene/maps.h"

#include "scene/load.h"
#include "system/system.h"

/* What is kept free at the ends of a piece: the head of a block, and the walls that AROS puts around each
   block to see whether a program writes beyond it, 72 bytes before it and 32 behind. */
enum { WALLS = 128 };

/* A free piece of memory, and a header of exec's list. */
struct piece {
    const struct piece *next;
    uint32 bytes;
};
struct memory_list {
    const struct memory_list *next, *before;
    uint8 type, priority;
    uint16 name[2];             /* an address */
    uint16 attributes;          /* of enum memory_type */
    const struct piece *first;
};

/* Finds the free piece of a kind that has the most whole units, each at a multiple of `unit`, but not more
   than `count`. Returns how many; *memory is the first. */
static uint32 find_units(uint8 **memory, uint32 unit, uint32 count, int32 kind)
{
    const struct memory_list *list = (const struct memory_list *)mem_lists();
    uint32 most = 0;

    for (; list->next && most < count; list = list->next) {
        const struct piece *piece = list->attributes & kind ? list->first : 0;

        for (; piece && most < count; piece = piece->next) {
            const uint32 first = ((uint32)piece + WALLS + unit - 1) & ~(unit - 1);
            const uint32 end = (uint32)piece + piece->bytes - WALLS;
            const uint32 units = end > first ? (end - first) / unit : 0;

            if (units > most) {
                most = units;
                *memory = (uint8 *)first;
            }
        }
    }
    return most < count ? most : count;
}

/* Takes memory for up to `count` units; returns how many it got. */
static uint32 take_units(uint8 **memory, uint32 unit, uint32 count, int32 kind)
{
    uint32 found;

    tasks_forbid();
    found = find_units(memory, unit, count, kind);
    if (found && !mem_take_at(*memory, (int32)(found * unit)))
        found = 0;
    tasks_permit();
    return found;
}

/* The kinds of memory that are tried for a kind that a caller wants, until one has enough. */
static const int32 *kinds_of(int32 kind)
{
    static const int32 any[] = {MEMORY_FAST, MEMORY_CHIP, 0}, chip[] = {MEMORY_CHIP, 0},
                       fast[] = {MEMORY_FAST, 0};

    return kind == MEMORY_CHIP ? chip : kind == MEMORY_FAST ? fast : any;
}

/* Returns how many textures of an order are left from number `at` on. */
static uint32 count_order(const struct scene *scene, uint32 at, enum map_order order)
{
    uint32 found = 0;

    for (; at < scene->header->textures; at++)
        found += scene_map_order(&scene->textures[at]) == order;
    return found;
}

/* Notes the memory that mem_alloc lacks, for the message. */
static int32 lack(uint32 bytes, int32 kind)
{
    uint8 *none;

    return mem_alloc(&none, (int32)bytes, kind) && 0;
}

/* Takes memory for all maps of an order. A map has `each` units, the first of a block begins `before` bytes
   behind a unit's start, and a block needs `rest` units more. */
static int32 take_order(struct scene *scene, enum map_order order, int32 kind)
{
    const uint32 unit = order == ORDER_LIGHT ? LIGHT_BYTES : PAGE_BYTES;
    const uint32 each = order == ORDER_MARGINS ? 2 : 1, rest = each - 1;
    const uint32 before = order == ORDER_MARGINS ? HALF_PAGE : 0;
    const int32 *kinds = kinds_of(kind);
    uint32 left = count_order(scene, 0, order), at = 0, here = 0;
    uint8 *memory = 0;

    for (; left; at++) {
        const struct scene_texture *t = &scene->textures[at];

        if (scene_map_order(t) != order)
            continue;
        while (!here) {
            uint32 units;

            if (!*kinds)
                return lack((each + rest + 1) * unit, kind);
            units = take_units(&memory, unit, left * each + rest, *kinds);
            here = units > rest ? (units - rest) / each : 0;
            memory += before;
            if (!here)
                kinds++;
        }
        scene_map_place(&scene->maps[at], t, memory);
        memory += each * unit;
        here--;
        left--;
    }
    return 1;
}

static int32 take_others(struct scene *scene, int32 kind)
{
    for (uint32 i = 0; i < scene->header->textures; i++) {
        const struct scene_texture *t = &scene->textures[i];
        const uint32 bytes = scene_map_bytes(t);
        uint8 *memory;

        if (scene_map_order(t) != ORDER_ANYWHERE)
            continue;
        if (!mem_take(&memory, (int32)bytes, kind))
            return lack(bytes, kind);
        scene_map_place(&scene->maps[i], t, memory);
    }
    return 1;
}

int32 scene_take_maps(struct scene *scene, int32 kind)
{
    const uint32 bytes = scene->header->textures * (uint32)sizeof *scene->maps;

    if (!mem_alloc(&scene->maps, (int32)bytes, MEMORY_ANY))
        return 0;
    for (uint32 order = 0; order < ORDER_ANYWHERE; order++)
        if (!take_order(scene, (enum map_order)order, kind))
            return 0;
    return take_others(scene, kind);
}

/* Reads a map that is repeated over a page, into the page's last bytes first. Of wider texels, whose page
   begins with row 128, the halves of a map of 256 rows change places. */
static int32 read_page(const struct scene_texture *t, struct file_input *input, uint8 *page)
{
    const int32 bytes = (int32)t->texel_bytes, row = MAP_PAGE_SIDE * bytes;
    const uint32 all = (uint32)(t->width * t->height * bytes);
    const uint32 first = bytes > 1 && t->height == MAP_PAGE_SIDE ? all / 2 : all;
    uint8 *from = page + row * MAP_PAGE_SIDE - all;

    if (!file_input_read(input, from + (all - first), first)
        || (first < all && !file_input_read(input, from, all - first)))
        return 0;
    if (from != page)
        scene_page_fill(page, from, t->width * bytes, t->height, row, 0);
    return 1;
}

int32 scene_read_maps(struct scene *scene, struct file_input *input)
{
    for (uint32 i = 0; i < scene->header->textures; i++) {
        const struct scene_texture *t = &scene->textures[i];
        const uint32 bytes = (uint32)(t->width * t->height) * t->texel_bytes;
        uint8 *texels = (uint8 *)scene->maps[i].texels;
        uint8 padding[4];

        if (t->layout == MAP_PAGE) {
            if (!read_page(t, input, t->texel_bytes > 1 ? texels - HALF_PAGE * t->texel_bytes : texels))
                return 0;
        } else if (!file_input_read(input, texels, bytes)) {
            return 0;
        }
        if (t->layout == MAP_MARGINS)
            scene_margins_fill(texels);
        else if (t->layout == MAP_LIGHT)
            scene_judge_light(&scene->maps[i]);
        if (bytes & 3 && !file_input_read(input, padding, 4 - (bytes & 3)))
            return 0;
    }
    return 1;
}
