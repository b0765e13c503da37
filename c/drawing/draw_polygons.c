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
        return renderer->triangles->run(renderer, polygons, count, material, polygon_draw_exact);
    is_set = three_set(&three, renderer, material);
    for (; count > 0; count--, polygons++) {
        result = is_set && polygons->count == 3 ? three_polygon(&three, polygons->vertices)
                                                : (enum polygon_result)THREE_OTHER;
        if ((int32)result == THREE_OTHER)
            result = polygon_draw_any(renderer, polygons, material);
        refused = result > POLYGON_EMPTY ? result : refused;
    }
    return refused;
}
