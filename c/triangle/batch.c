#include "triangle/batch.h"

void triangle_begin(struct triangle_batch *batch, const struct renderer *renderer,
                    const struct material *material)
{
    batch->material = material;
    batch->count = 0;
    batch->routine = 0;
    if (material->edges != EDGES_SNAPPED || !renderer->triangles || renderer->counts)
        return;
    batch->routine = triangle_routine(renderer->frame, material);
    triangle_plan_set(&batch->plan, renderer, material);
    triangle_range_set(&batch->range, renderer->frame, material);
    batch->plan.list = batch->list;
}

struct snapped_vertex *triangle_room(struct triangle_batch *batch)
{
    if (batch->count > BATCH_TRIANGLES - (TRIANGLE_CORNERS_MAX - 2))
        triangle_flush(batch);
    return &batch->vertices[3 * batch->count];
}

void triangle_add(struct triangle_batch *batch, int32 corners)
{
    const struct snapped_vertex *first = &batch->vertices[3 * batch->count];

    for (int32 i = 2; i < corners; i++) {
        struct triangle *to = &batch->list[batch->count++];

        to->a = first;
        to->b = &first[i - 1];
        to->c = &first[i];
    }
}

void triangle_flush(struct triangle_batch *batch)
{
    if (!batch->count)
        return;
    batch->plan.end = &batch->list[batch->count];
    batch->routine(&batch->plan);
    batch->count = 0;
}
