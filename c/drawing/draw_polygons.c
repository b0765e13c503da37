#include "drawing/three.h"
#include "triangle/triangles.h"

enum polygon_result polygons_draw(struct renderer *renderer, const struct polygon *polygons,
                                  int32 count, const struct material *material)
{
    const int32 plain = material->edges != EDGES_SNAPPED && is_plain(material);
    enum polygon_result refused = POLYGON_DRAWN;

    if (material->edges == EDGES_SNAPPED && renderer->triangles && !renderer->counts)
        return renderer->triangles->run(renderer, polygons, count, material, polygon_draw_whole);
    for (; count > 0; count--, polygons++) {
        polygon_routine *const draw = begins_outside(renderer, polygons) ? polygon_draw_beyond
                                    : plain && polygons->count == 3 ? polygon_draw_three
                                                                    : polygon_draw;
        const enum polygon_result result = draw(renderer, polygons, material);

        refused = result > POLYGON_EMPTY ? result : refused;
    }
    return refused;
}
