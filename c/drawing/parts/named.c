#include "drawing/parts/named.h"

int32 material_is_named(const struct material *material, int32 pixel_bytes)
{
    uint32 needs = (uint32)1 << material->mapper;

    if (pixel_bytes != 1)
        needs |= pixel_bytes == 2 ? (uint32)PART_16 : (uint32)PART_32;
    if (material->mapper != MAPPER_FLAT) {
        if (material->gradients == GRADIENTS_SCANLINE)
            needs |= PART_SCANLINE;
        else if (material->gradients == GRADIENTS_POLYGON || material->start == START_TRUNCATED)
            needs |= PART_STARTS;
        if (material->perspective)
            needs |= PART_PERSPECTIVE;
        if (material->perspective >= PERSPECTIVE_PIXEL)
            needs |= PART_CURVES;
    }
    if (material->clip == CLIP_VERTICES && !EDGES_ARE_EXACT(material->edges))
        needs |= PART_CLIPPING;
    return !(needs & ~drawing_parts);
}
