#include "drawing/page.h"

#include "drawing/draw.h"
#include "drawing/plan.h"
#include "drawing/ways.h"
#include "polygon/key.h"
#include "system/memory.h"

enum { SIDE = MAP_PAGE_SIDE, HALF_LEAST = 16 };

static void forget(struct page *page)
{
    page->from = page->end = 0;
}

int32 page_has(struct page *page, const uint32 *key, int32 words, const struct page_rows *rows)
{
    if (key_differs(page->key, key, words))
        forget(page);
    return page->from < page->end && rows->first >= page->from && rows->last < page->end;
}

/* Returns the first row in memory. A whole page has rows 128 to 255 before row 0, as MAP_PAGE. */
static int32 first_row(const struct page *page)
{
    return page->half < SIDE / 2 ? PAGE_MIDDLE - page->half : -SIDE / 2;
}

int32 page_ready(struct page *page, int32 pixel_bytes, int32 memory,
                 const struct page_rows *rows)
{
    const int32 pitch = SIDE * pixel_bytes;
    int32 half = page->half > HALF_LEAST ? page->half : HALF_LEAST;

    while (half < SIDE / 2 && (rows->first < PAGE_MIDDLE - half
                               || rows->last >= PAGE_MIDDLE + half))
        half *= 2;
    if (half != page->half || page->bytes < 2 * half * pitch) {
        forget(page);
        page->half = half;
        page->bytes = mem_take(&page->texels, 2 * half * pitch, memory) ? 2 * half * pitch : 0;
    }
    page->map.texels = page->texels - first_row(page) * pitch;
    page->map.width = page->map.height = SIDE;
    page->map.scale = 65536;
    page->map.layout = MAP_PAGE;
    page->map.texel_bytes = (uint8)pixel_bytes;
    page->map.full = page->map.dark = 0;
    page->map.rows = 0;
    return page->bytes > 0;
}

void page_grow(struct page *page, const struct page_rows *rows, page_row_maker *make,
               void *context)
{
    if (page->from == page->end)
        page->from = page->end = rows->first;
    for (; page->from > rows->first; page->from--)
        make(context, page->from - 1, page->from, page->end);
    for (; page->end <= rows->last; page->end++)
        make(context, page->end, page->from, page->end);
}

uint8 *page_row(const struct page *page, int32 v)
{
    return (uint8 *)page->map.texels + (int8)v * SIDE * page->map.texel_bytes;
}

int32 page_is_within(const fix16 *value, int32 count, const struct page_window *window)
{
    fix16 low = window->origin + (window->least + PAGE_MARGIN) * 65536;
    fix16 high = low + (SIDE - 2 * PAGE_MARGIN) * 65536;

    if (window->period)
        return 1;
    for (; count > 0; count--, value += VERTEX_FIELDS)
        if (*value < low || *value >= high)
            return 0;
    return 1;
}

static int32 is_parallelogram(const struct vertex *v)
{
    return v[0].x + v[2].x == v[1].x + v[3].x && v[0].y + v[2].y == v[1].y + v[3].y
        && v[0].t + v[2].t == v[1].t + v[3].t;
}

/* Returns 1 if t of every pixel is less than a texel outside the vertices' range: t is one plane
   over all vertices and changes by 32 texels a pixel at most, and edges are off by 1/64 pixel. The
   area is in 1/256 square pixel, from corners in 1/16 pixel. */
static int32 keeps_range(const struct vertex *v, int32 count, fix16 range)
{
    fix16 least, width, height;
    int32 side, area;

    if (count > 4 || (count == 4 && !is_parallelogram(v)))
        return 0;
    width = vertex_range(&v->x, count, &least);
    height = vertex_range(&v->y, count, &least);
    side = ((width > height ? width : height) >> 16) + 1;
    if (width < 0 || height < 0 || side > 1024)
        return 0;
    area = ((v[1].x - v[0].x) >> 12) * ((v[2].y - v[0].y) >> 12)
        - ((v[2].x - v[0].x) >> 12) * ((v[1].y - v[0].y) >> 12);
    return (area < 0 ? -area : area) >= 16 * side * ((range >> 16) + 5);
}

/* The values of s or t that a polygon's vertices have. */
struct page_range {
    fix16 least, range;
};

/* Returns what is column or row 0. */
static inline fix16 origin_of(const struct page_range *of, const struct page_window *window)
{
    fix16 middle;

    if (!window->period)
        return window->origin;
    middle = of->least + (of->range >> 1) - window->origin - (window->least + SIDE / 2) * 65536;
    return window->origin + ((middle + (window->period >> 1)) & -window->period);
}

const struct vertex *page_vertices(struct vertex *to, const struct vertex *given, int32 count,
                                   const struct page_window *columns, const struct page_window *rows,
                                   struct page_rows *shown)
{
    const int32 least = rows->least, end = least + SIDE;
    struct page_range s, t;
    fix16 u, v;

    s.range = vertex_range(&given->s, count, &s.least);
    t.range = vertex_range(&given->t, count, &t.least);
    u = origin_of(&s, columns);
    v = origin_of(&t, rows);
    shown->first = ((t.least - v) >> 16) - PAGE_MARGIN;
    shown->last = ((t.least + t.range - v) >> 16) + PAGE_MARGIN;
    if (shown->first < least || shown->last >= end || !keeps_range(given, count, t.range)) {
        shown->first = least;   /* all rows: the range is not known, or does not fit */
        shown->last = end - 1;
    }
    for (int32 i = 0; i < count; i++) {
        to[i].x = given[i].x;
        to[i].y = given[i].y;
        to[i].s = given[i].s - u;
        to[i].t = given[i].t - v;
    }
    return to;
}

void page_material(struct page *page, const struct material *from)
{
    struct material *plain = &page->plain;

    *plain = *from;
    plain->mapper = MAPPER_AFFINE;
    plain->gradients = GRADIENTS_PLANE;
    plain->start = START_SUBTEXEL;
    plain->whole = 1;
    plain->perspective = PERSPECTIVE_NONE;
    plain->map = &page->map;
}

enum polygon_result page_draw(struct setup *s, const struct vertex *vertices, struct page *page)
{
    enum polygon_result result;
    struct polygon polygon;

    polygon_set(&polygon, vertices, s->count, PLANAR_ALL);
    page->of = 0;
    if (begins_outside(s->renderer, &polygon) || page->plain.edges == EDGES_SNAPPED)
        return polygon_draw(s->renderer, &polygon, &page->plain);
    if (s->count == 3 && three_set(&page->three, s->renderer, &page->plain)) {
        page->of = s->material;
        return three_draw(&page->three, vertices);
    }
    s->form = s->renderer->form;
    s->given = vertices;
    s->material = &page->plain;
    result = plan_set_up(s);
    return result == POLYGON_DRAWN ? setup_draw(s) : result;
}

int32 page_is_same(const struct page *page, const struct renderer *renderer, const struct polygon *polygon,
                   const struct material *material)
{
    const struct frame *frame = renderer->frame;
    const struct setup *s = &page->three.s;

    return page->of == material && page->plain.edges == material->edges && page->plain.clip == material->clip
        && s->scratch == renderer->scratch && !renderer->counts && !renderer->off && renderer->form == FORM_ADDX
        && frame->pitch == s->span.pitch && frame->pixel_bytes == page->map.texel_bytes
        && !begins_outside(renderer, polygon);
}

enum polygon_result page_again(struct page *page, const struct renderer *renderer, const struct vertex *vertices)
{
    const struct frame *frame = renderer->frame;
    struct three *three = &page->three;

    three->s.frame = frame;
    three->s.span.map = page->map.texels;
    three->row = frame->pixels - EDGE_BIAS * frame->pixel_bytes;
    three->right = (uint32)frame->width << 16;
    return three_draw(three, vertices);
}

int32 page_room(void *address, uint32 *has, uint32 count, uint32 size)
{
    if (*has < count)
        *has = mem_take(address, (int32)(count * size), MEMORY_ANY) ? count : 0;
    return *has > 0;
}
