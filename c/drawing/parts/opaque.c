#include "drawing/outline.h"
#include "polygon/counts.h"

void outline_opaque(struct setup *s)
{
    const struct map *map = s->material->map;
    struct opaque_plan plan;

    if (!map->rows || !RULE_IS_ON(s, OPAQUE_ROWS))
        return;
    RULE_APPLIES(s, OPAQUE_ROWS);
    plan.lines = s->edges.lines;
    plan.count = s->span.count;
    plan.dudx = s->span.dudx;
    plan.rows = map->rows;
    plan.width = map->width;
    plan.height = map->height;
    edge_opaque(&plan);
    s->kind = SPAN_KEYED_ROWS;
}
