#include "triangle/polygon.h"

#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/scratch.h"

/* Sets the fields that only triangles_spans reads. */
static void triangle_spans_set(struct triangle_plan *plan, enum span_kind kind,
                               struct triangle_lines *to, const struct renderer *renderer,
                               const struct material *material)
{
    const struct frame *const frame = renderer->frame;
    const int32 has_levels = kind == SPAN_LIT_GOURAUD;

    plan->row -= EDGE_BIAS * frame->pixel_bytes;
    plan->lines = material->mapper == MAPPER_FLAT ? triangle_lines_flat
                : has_levels ? triangle_lines_levels : triangle_lines_addx;
    plan->kind = plan->lowered = kind;
    plan->only_counts = renderer->counts && renderer->only_counts;
    plan->off = renderer->off;
    plan->light = kind == SPAN_LIT || kind == SPAN_LIT_WRAP || has_levels
                ? material->light->texels : 0;
    plan->shades = has_levels ? renderer->scratch->room : 0;
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

triangle_drawer *triangle_plan_set(struct triangle_plan *plan, enum span_kind kind,
                                   struct triangle_lines *to, const struct renderer *renderer,
                                   const struct material *material)
{
    plan->row = renderer->frame->pixels;
    plan->pitch = renderer->frame->pitch;
    plan->map = material->map ? material->map->texels : 0;
    plan->reciprocals = renderer->triangles->reciprocals;
    plan->colour = material->colour * 0x01010101;
    plan->cull = 0;
    if (kind == SPAN_TRIANGLES_AFFINE)
        return triangles_affine;
    if (kind == SPAN_TRIANGLES_FLAT)
        return triangles_flat;
    if (kind == SPAN_TRIANGLES_GOURAUD)
        return triangles_gouraud;
    triangle_spans_set(plan, kind, to, renderer, material);
    return triangles_spans;
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

/* Returns the cheapest span for the steps of a triangle's lines. */
static enum span_kind triangle_lowered(const struct triangle_plan *plan)
{
    const fix16 dudx = plan->span->dudx, dvdx = plan->span->dvdx;
    const int32 row = STEP_IS_STILL(dvdx) && STEP_IS_SLOW(dudx) && RULE_IS_ON(plan, STILL_V);
    const int32 copy = row && STEP_IS_STILL(dudx - 65536) && RULE_IS_ON(plan, UNIT_STEP);

    switch (plan->kind) {
    case SPAN_AFFINE_ADDX:
    case SPAN_AFFINE_ADDX_WRAP:
        return copy ? SPAN_AFFINE_COPY : row ? SPAN_AFFINE_ROW
             : STEP_IS_STILL(dudx) && STEP_IS_SLOW(dvdx) && RULE_IS_ON(plan, STILL_U)
             ? SPAN_AFFINE_COLUMN : (enum span_kind)plan->kind;
    case SPAN_AFFINE_16:
        return copy ? SPAN_AFFINE_16_COPY : row ? SPAN_AFFINE_16_ROW : SPAN_AFFINE_16;
    case SPAN_AFFINE_32:
        return row ? SPAN_AFFINE_32_ROW : SPAN_AFFINE_32;
    default:
        return plan->kind;
    }
}

const struct triangle *triangles_spans(struct triangle_plan *plan)
{
    struct span_plan *const span = plan->span;

    for (;;) {
        const struct triangle *const next = plan->lines(plan);
        enum span_kind kind;

        if (!span->count)
            return next;
        if (plan->shades)
            triangle_levels(span, plan->shade);
        else if (plan->light)
            span->light = plan->light + 256 * (next[-1].a->level >> 20);
        kind = triangle_lowered(plan);
        plan->lowered = kind;
        if (!plan->only_counts)
            kind_spans[kind](span);
        plan->list = next;
    }
}
