#include "drawing/three.h"

enum polygon_result polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                 const struct material *material)
{
    if (begins_outside(renderer, polygon))
        return polygon_draw_beyond(renderer, polygon, material);
    if (material->edges == EDGES_SNAPPED)
        return polygon_draw_inside(renderer, polygon, material);
    return polygon->count == 3 && is_plain(material)
         ? polygon_draw_three(renderer, polygon, material)
         : polygon_draw_whole(renderer, polygon, material);
}
