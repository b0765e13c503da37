#include "triangle/polygon.h"

#include "polygon/kind.h"
#include "polygon/scratch.h"
#include "polygon/shading.h"

static int32 triangle_has_map(const struct material *material, int32 pixel_bytes)
{
    return material->map && material->map->layout == MAP_PAGE
        && material->map->texel_bytes == pixel_bytes;
}

triangle_drawer *triangle_routine(const struct frame *frame, const struct material *material)
{
    if (frame->pitch > TRIANGLE_PITCH_MAX)
        return 0;
    if (material->mapper == MAPPER_FLAT)
        return frame->pixel_bytes == 1 ? triangles_flat : triangles_spans;
    if (material->gradients != GRADIENTS_PLANE || material->start != START_SUBTEXEL
        || material->perspective)
        return 0;
    if (material->mapper == MAPPER_AFFINE && triangle_has_map(material, frame->pixel_bytes))
        return frame->pixel_bytes == 1 ? triangles_affine : triangles_spans;
    if (frame->pixel_bytes != 1)
        return 0;
    if (material->mapper == MAPPER_GOURAUD)
        return triangles_gouraud;
    return material->mapper == MAPPER_LIT && triangle_has_map(material, 1) && material->light
        && material->light->layout == MAP_LIGHT ? triangles_spans : 0;
}

/* Sets what triangles_spans needs besides. */
static void triangle_spans_set(struct triangle_plan *plan, const struct renderer *renderer,
                               const struct material *material)
{
    const struct frame *const frame = renderer->frame;

    plan->row -= EDGE_BIAS * frame->pixel_bytes;
    plan->lines = material->mapper == MAPPER_FLAT ? triangle_lines_flat : triangle_lines_addx;
    plan->draw = kind_spans[triangle_kind(frame, material)];
    plan->light = material->mapper == MAPPER_LIT ? material->light->texels : 0;
    plan->span->lines = renderer->scratch->lines;
    plan->span->pitch = frame->pitch;
    plan->span->map = plan->map;
    plan->span->colour = material->colour;
}

void triangle_plan_set(struct triangle_plan *plan, struct span_plan *span,
                       const struct renderer *renderer, const struct material *material)
{
    plan->span = span;
    plan->row = renderer->frame->pixels;
    plan->pitch = renderer->frame->pitch;
    plan->map = material->map ? material->map->texels : 0;
    plan->reciprocals = renderer->triangles->reciprocals;
    plan->colour = material->colour * 0x01010101;
    plan->cull = 0;
    if (triangle_routine(renderer->frame, material) == triangles_spans)
        triangle_spans_set(plan, renderer, material);
}

const struct triangle *triangles_spans(struct triangle_plan *plan)
{
    for (;;) {
        const struct triangle *const next = plan->lines(plan);

        if (!plan->span->count)
            return next;
        if (plan->light)
            plan->span->light = plan->light + 256 * (next[-1].a->shade >> LEVEL_BITS);
        plan->draw(plan->span);
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
    const fix16 scale = material->map ? material->map->scale : 0;
    struct triangle_range range;
    int32 all = 1;

    triangle_range_set(&range, frame);
    for (; count > 0; count--, to++, from++) {
        fix16 low = from->shade, high = low;

        to->shade = low;
        if (!triangle_vertex(to, &range, scale, from)) {
            to->x = -1;
            all = 0;
        } else if (is_shaded) {
            shade_limits(&low, &high);
            to->u = triangle_value(shade_limited(from->shade, low, high));
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
    struct span_plan span;
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
    triangle_plan_set(&plan, &span, renderer, material);
    plan.list = list;
    plan.end = &list[polygon->count - 2];
    routine(&plan);
    return 1;
}
