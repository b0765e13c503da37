#include "polygon/page.h"

enum { SIDE = MAP_PAGE_SIDE };

static const fix16 *next(const fix16 *value)
{
    return value + sizeof(struct vertex) / sizeof *value;
}

int32 page_is_within(const struct setup *s, const fix16 *value, const struct page_window *window)
{
    fix16 low = window->origin + (window->least + PAGE_MARGIN) * 65536;
    fix16 high = low + (SIDE - 2 * PAGE_MARGIN) * 65536;

    if (window->period)
        return 1;
    for (int32 i = 0; i < s->count; i++, value = next(value))
        if (*value < low || *value >= high)
            return 0;
    return 1;
}

fix16 page_origin(const struct setup *s, const fix16 *value, const struct page_window *window)
{
    fix16 least = *value, most = *value, middle;

    if (!window->period)
        return window->origin;
    for (int32 i = 1; i < s->count; i++) {
        value = next(value);
        least = *value < least ? *value : least;
        most = *value > most ? *value : most;
    }
    middle = (least >> 1) + (most >> 1) - window->origin - (window->least + SIDE / 2) * 65536;
    return window->origin + ((middle + (window->period >> 1)) & -window->period);
}

const struct vertex *page_vertices(const struct setup *s, fix16 s_origin, fix16 t_origin)
{
    static struct vertex moved[POLYGON_VERTICES_MAX];

    for (int32 i = 0; i < s->count; i++) {
        moved[i] = s->given[i];
        moved[i].s -= s_origin;
        moved[i].t -= t_origin;
    }
    return moved;
}

void page_map(struct map *map, int32 pixel_bytes)
{
    map->width = map->height = SIDE;
    map->scale = 65536;
    map->layout = MAP_PAGE;
    map->texel_bytes = (uint8)pixel_bytes;
    map->full = map->dark = 0;
}

void page_material(struct material *plain, const struct material *from, const struct map *map)
{
    *plain = *from;
    plain->mapper = MAPPER_AFFINE;
    plain->gradients = GRADIENTS_PLANE;
    plain->start = START_SUBTEXEL;
    plain->whole = 1;
    plain->perspective = PERSPECTIVE_NONE;
    plain->map = map;
}
