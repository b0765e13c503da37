#include "drawing/draw.h"
#include "drawing/three.h"

enum polygon_result polygon_draw_three(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    struct three three;

    return three_set(&three, renderer, material) ? three_polygon(&three, polygon->vertices)
                                                 : polygon_draw_inside(renderer, polygon, material);
}
