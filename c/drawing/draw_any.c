/* Polygons that are counted or left out. */
#include "drawing/draw.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "polygon/counts.h"
#include "polygon/setup.h"

void polygon_count_snapped(struct renderer *renderer, const struct polygon *polygon,
                           const struct material *material, enum span_kind kind)
{
    struct setup s;

    setup_begin(&s, renderer, polygon, material);
    s.vertices = material_vertices(s.scratch->vertices, s.given, s.count, material);
    s.kind = kind;
    if (outline_find(&s, OUTLINE_ALONE) != POLYGON_DRAWN)
        return;
    s.span.lines = s.edges.lines;
    s.span.count = s.box.bottom - s.box.top;
    outline_lines(&s, edge_flat_exact, scissor_flat);
    count_lines(&s, s.kind);
}

enum polygon_result polygon_draw_beyond(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    struct setup s;             /* what lower_to_nothing reads */

    s.off = renderer->off;
    s.applied = 0;
    s.frame = renderer->frame;
    s.material = material;
    s.given = polygon->vertices;
    s.count = polygon->count;
    if (!is_polygon(polygon) || !lower_to_nothing(&s))
        return polygon_draw_inside(renderer, polygon, material);
    if (renderer->counts)
        renderer->counts[material->number].rules[RULE_OUTSIDE]++;
    return POLYGON_EMPTY;
}
