#include "drawing/draw.h"

#include "drawing/three.h"

enum polygon_result polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                 const struct material *material)
{
    struct three three;

    if (polygon->count == 3 && three_set(&three, renderer, material)) {
        const enum polygon_result result = three_polygon(&three, polygon->vertices);

        if ((int32)result != THREE_OTHER)
            return result;
    }
    return polygon_draw_any(renderer, polygon, material);
}
