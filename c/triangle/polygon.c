#include "triangle/polygon.h"

#include "polygon/kind.h"
#include "polygon/scratch.h"
#include "polygon/shading.h"

/* Returns non-zero if a material's map, and its light table, are those of spans of this many bytes a
   pixel. */
static int32 triangle_has_maps(const struct material *material, int32 pixel_bytes)
{
    const struct map *const map = material->map, *const light = material->light;

    return map && map->layout == MAP_PAGE && map->texel_bytes == pixel_bytes
        && (material->mapper == MAPPER_AFFINE || (light && light->layout == MAP_LIGHT));
}

triangle_drawer *triangle_routine(const struct frame *frame, const struct material *material)
{
    const int32 wide = frame->pixel_bytes != 1;

    if (frame->pitch > TRIANGLE_PITCH_MAX)
        return 0;
    if (material->mapper == MAPPER_FLAT)
        return wide ? triangles_spans : triangles_flat;
    if (material->gradients != GRADIENTS_PLANE || material->start != START_SUBTEXEL
        || material->perspective)
        return 0;
    if (material->mapper == MAPPER_GOURAUD)
        return wide ? 0 : triangles_gouraud;
    if (material->mapper != MAPPER_AFFINE
        && (wide || (material->mapper != MAPPER_LIT && material->mapper != MAPPER_LIT_GOURAUD)))
        return 0;
    return !triangle_has_maps(material, frame->pixel_bytes) ? 0
         : wide || material->mapper != MAPPER_AFFINE ? triangles_spans : triangles_affine;
}

/* Sets what triangles_spans needs besides. */
static void triangle_spans_set(struct triangle_plan *plan, struct triangle_lines *to,
                               const struct renderer *renderer, const struct material *material)
{
    const struct frame *const frame = renderer->frame;

    plan->row -= EDGE_BIAS * frame->pixel_bytes;
    plan->lines = material->mapper == MAPPER_FLAT ? triangle_lines_flat
                : material->mapper == MAPPER_LIT_GOURAUD ? triangle_lines_levels
                : triangle_lines_addx;
    plan->draw = kind_spans[triangle_kind(frame, material)];
    plan->light = material->light ? material->light->texels : 0;
    plan->shades = material->mapper == MAPPER_LIT_GOURAUD ? renderer->scratch->room : 0;
    plan->span = &to->span;
    plan->shade = &to->shade;
    to->span.lines = to->shade.lines = renderer->scratch->lines;
    to->span.pitch = frame->pitch;
    to->span.map = plan->map;
    to->span.colour = material->colour;
    to->span.light = plan->light;
    to->span.shades = to->shade.shades = plan->shades;
    to->shade.inside = 1;
}

void triangle_plan_set(struct triangle_plan *plan, triangle_drawer *routine,
                       struct triangle_lines *to, const struct renderer *renderer,
                       const struct material *material)
{
    plan->row = renderer->frame->pixels;
    plan->pitch = renderer->frame->pitch;
    plan->map = material->map ? material->map->texels : 0;
    plan->reciprocals = renderer->triangles->reciprocals;
    plan->colour = material->colour * 0x01010101;
    plan->cull = 0;
    if (routine == triangles_spans)
        triangle_spans_set(plan, to, renderer, material);
}

/* Sets the levels of a triangle's lines. */
static void triangle_levels(struct span_plan *span, struct shade_plan *shade)
{
    shade->count = span->count;
    shade->added = (uint32)span->light & 0xffff;
    if (span->dvdx & 0x800000)
        shade->added += SHADE_FALLS;
    edge_shade(shade);
    span->dcdx = shade->dcdx;
}

const struct triangle *triangles_spans(struct triangle_plan *plan)
{
    struct span_plan *const span = plan->span;

    for (;;) {
        const struct triangle *const next = plan->lines(plan);

        if (!span->count)
            return next;
        if (plan->shades)
            triangle_levels(span, plan->shade);
        else if (plan->light)
            span->light = plan->light + 256 * (next[-1].a->level >> 20);
        plan->draw(span);
        plan->list = next;
    }
}

/* Returns a value in 1/2^20, raised. */
static int32 triangle_value(fix16 value)
{
    return (int32)((uint32)(value + SNAPPED_RAISED) << 4);
}

/* Sets a vertex's place and, with a map, u and v. Returns 0 if it is out of range. */
static int32 triangle_vertex(struct snapped_vertex *to, const struct triangle_range *range,
                             fix16 scale, const struct vertex *from)
{
    const uint32 reach = (uint32)SNAPPED_TEXELS << 16;
    const int32 x = (from->x + SNAPPED_HALF) >> (16 - SNAPPED_BITS);
    const int32 y = (from->y + SNAPPED_HALF) >> (16 - SNAPPED_BITS);
    fix16 s = from->s, t = from->t;

    if ((uint32)x > range->right || (uint32)y > range->bottom)
        return 0;
    to->x = (int16)(x + SNAPPED_ONE);
    to->y = (int16)(y + SNAPPED_ONE - 1);
    if (!scale)
        return 1;
    if (scale != 65536) {
        s = mul_round(s, scale);
        t = mul_round(t, scale);
    }
    to->u = triangle_value(s);
    to->v = triangle_value(t);
    return (uint32)s + reach < 2 * reach && (uint32)t + reach < 2 * reach;
}

/* Returns non-zero if vertices cover fewer than SNAPPED_LINES lines. */
static int32 triangle_is_low(const struct snapped_vertex *v, int32 count)
{
    int32 top = v->y, low = top;

    while (--count > 0) {
        v++;
        top = v->y < top ? v->y : top;
        low = v->y > low ? v->y : low;
    }
    return low - top < SNAPPED_LINES * SNAPPED_ONE;
}

int32 triangle_vertices(struct snapped_vertex *to, const struct vertex *from, int32 count,
                        const struct frame *frame, const struct material *material)
{
    const int32 is_shaded = material->mapper == MAPPER_GOURAUD;
    const int32 is_lit = material->light != 0;
    const fix16 scale = material->map ? material->map->scale : 0;
    struct triangle_range range;
    int32 all = 1;

    triangle_range_set(&range, frame);
    for (; count > 0; count--, to++, from++) {
        fix16 low = from->shade, high = low;

        if (!triangle_vertex(to, &range, scale, from)) {
            to->x = -1;
            all = 0;
        } else if (is_shaded) {
            shade_limits(&low, &high);
            to->u = triangle_value(shade_limited(from->shade, low, high));
        } else if (is_lit) {
            const fix16 level = SHADE_LEVEL(from->shade);

            low = high = level;
            shade_limits(&low, &high);
            to->level = shade_limited(level, low, high) << 4;
        }
    }
    return all;
}

int32 triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                       const struct material *material)
{
    triangle_drawer *const routine = triangle_routine(renderer->frame, material);
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX];
    struct triangle list[TRIANGLE_CORNERS_MAX - 2];
    struct triangle_plan plan;
    struct triangle_lines lines;
    int32 i;

    if (!routine || polygon->count > TRIANGLE_CORNERS_MAX
        || !triangle_vertices(vertices, polygon->vertices, polygon->count, renderer->frame, material)
        || !triangle_is_low(vertices, polygon->count))
        return 0;
    if (renderer->counts && renderer->only_counts)
        return 1;
    for (i = 2; i < polygon->count; i++) {
        list[i - 2].a = vertices;
        list[i - 2].b = &vertices[i - 1];
        list[i - 2].c = &vertices[i];
    }
    triangle_plan_set(&plan, routine, &lines, renderer, material);
    plan.list = list;
    plan.end = &list[polygon->count - 2];
    routine(&plan);
    return 1;
}
