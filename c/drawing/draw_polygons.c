/* Many polygons of one material. */
#include "drawing/deep.h"
#include "drawing/draw.h"
#include "drawing/three.h"
#include "triangle/triangles.h"

enum polygon_result polygons_draw(struct renderer *renderer, const struct polygon *polygons,
                                  int32 count, const struct material *material)
{
    enum polygon_result result, refused = POLYGON_DRAWN;
    union {                     /* one at a time */
        struct three three;
        struct deep deep;
    } plan;
    struct three *const three = &plan.three;
    const struct polygon *const end = polygons + count;
    int32 is_set;

    if (material->edges == EDGES_SNAPPED && renderer->triangles && !renderer->counts)
        return renderer->triangles->run(renderer, polygons, count, material, polygon_draw_whole);
    is_set = three_set(three, renderer, material);
    if (!is_set && material->perspective)
        return deep_run(&plan.deep, renderer, polygons, end, material);
    for (;; polygons++) {
        if (is_set && three->vertices != THREE_MADE)
            polygons = three_run(three, polygons, end);
        if (polygons == end)
            return refused;
        if (begins_outside(renderer, polygons))
            result = polygon_draw_beyond(renderer, polygons, material);
        else if (is_set && polygons->count == 3)
            result = three_polygon(three, polygons->vertices);
        else
            result = polygon_draw_inside(renderer, polygons, material);
        refused = result > POLYGON_EMPTY ? result : refused;
    }
}
