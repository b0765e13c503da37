#include "drawing/draw.h"
#include "drawing/material.h"
#include "drawing/outline.h"
#include "polygon/counts.h"

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
