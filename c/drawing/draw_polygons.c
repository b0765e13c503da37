#include "drawing/draw.h"
#include "drawing/three.h"
#include "triangle/triangles.h"

enum polygon_result polygons_draw(struct renderer *renderer, const struct polygon *polygons,
                                  int32 count, const struct material *material)
{
    enum polygon_result result, refused = POLYGON_DRAWN;
    struct three three;
    int32 is_set;

    if (material->edges == EDGES_SNAPPED && renderer->triangles && !renderer->counts)
        return renderer->triangles->run(renderer, polygons, count, material, polygon_draw_whole);
    is_set = three_set(&three, renderer, material);
    for (; count > 0; count--, polygons++) {
        if (begins_outside(renderer, polygons))
            result = polygon_draw_beyond(renderer, polygons, material);
        else if (is_set && polygons->count == 3)
            result = three_polygon(&three, polygons->vertices);
        else
            result = polygon_draw_inside(renderer, polygons, material);
        refused = result > POLYGON_EMPTY ? result : refused;
    }
    return refused;
}
