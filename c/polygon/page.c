#include "polygon/page.h"

#include "system/system.h"

enum { SIDE = MAP_PAGE_SIDE };

int32 page_ready(struct page *page, int32 pixel_bytes, int32 memory)
{
    const int32 bytes = SIDE * SIDE * pixel_bytes;

    if (page->bytes < bytes)
        page->bytes = mem_alloc(&page->texels, bytes, memory) ? bytes : 0;
    page->map.texels = page->texels + SIDE / 2 * SIDE * pixel_bytes;
    page->map.width = page->map.height = SIDE;
    page->map.scale = 65536;
    page->map.layout = MAP_PAGE;
    page->map.texel_bytes = (uint8)pixel_bytes;
    page->map.full = page->map.dark = 0;
    return page->bytes > 0;
}

static const fix16 *next(const fix16 *value)
{
    return value + sizeof(struct vertex) / sizeof *value;
}

int32 page_is_within(const struct setup *s, const fix16 *value, const struct page_window *window)
{
    fix16 low = window->origin + PAGE_MARGIN * 65536;
    fix16 high = low + (SIDE - 2 * PAGE_MARGIN) * 65536;

    if (window->period)
        return 1;
    for (int32 i = 0; i < s->count; i++, value = next(value))
        if (*value < low || *value >= high)
            return 0;
    return 1;
}

static fix16 moved(const struct setup *s, const fix16 *value, const struct page_window *window)
{
    fix16 least = *value, most = *value, middle;

    if (!window->period)
        return window->origin;
    for (int32 i = 1; i < s->count; i++) {
        value = next(value);
        least = *value < least ? *value : least;
        most = *value > most ? *value : most;
    }
    middle = (least >> 1) + (most >> 1) - window->origin - SIDE / 2 * 65536;
    return window->origin + ((middle + (window->period >> 1)) & -window->period);
}

const struct vertex *page_vertices(const struct setup *s, const struct page_window *columns,
                                   const struct page_window *rows)
{
    static struct vertex vertices[POLYGON_VERTICES_MAX];
    const fix16 u = moved(s, &s->given->s, columns), v = moved(s, &s->given->t, rows);

    for (int32 i = 0; i < s->count; i++) {
        vertices[i] = s->given[i];
        vertices[i].s -= u;
        vertices[i].t -= v;
    }
    return vertices;
}

void page_material(struct material *plain, const struct material *from, const struct page *page)
{
    *plain = *from;
    plain->mapper = MAPPER_AFFINE;
    plain->gradients = GRADIENTS_PLANE;
    plain->start = START_SUBTEXEL;
    plain->whole = 1;
    plain->perspective = PERSPECTIVE_NONE;
    plain->map = &page->map;
}
