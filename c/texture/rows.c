#include "texture/map.h"

static void make_row(struct map_row *row, const uint8 *texels, int32 width)
{
    int32 first = 0, last = width - 1;

    while (first < width && !texels[first])
        first++;
    while (last > first && !texels[last])
        last--;
    row->holes = row->unused = 0;
    if (first == width) {
        row->first = 1;
        row->last = 0;
        return;
    }
    row->first = (uint8)first;
    row->last = (uint8)last;
    while (first < last)
        row->holes |= !texels[first++];
}

void map_rows_make(struct map_row *rows, const struct map *map)
{
    const uint8 *texels = map->texels;

    for (int32 v = map->height; v; v--, texels += MAP_PAGE_SIDE)
        make_row(rows++, texels, map->width);
}
