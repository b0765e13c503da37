#include "drawing/three.h"

/* Returns non-zero if the plain spans draw a triangle of the material, without perspective. */
static int32 is_plain(const struct material *material)
{
    return material->edges != EDGES_SNAPPED && material->mapper <= MAPPER_AFFINE
        && material->gradients != GRADIENTS_SCANLINE && !material->perspective && !material->whole
        && material->clip == CLIP_SCISSOR;
}

enum polygon_result polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                 const struct material *material)
{
    if (begins_outside(renderer, polygon))
        return polygon_draw_beyond(renderer, polygon, material);
    return polygon->count == 3 && is_plain(material)
         ? polygon_draw_three(renderer, polygon, material)
         : polygon_draw_inside(renderer, polygon, material);
}
