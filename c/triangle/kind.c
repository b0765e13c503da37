#include "triangle/polygon.h"

/* Returns non-zero if a material's map, and its light table, are those of spans of this many bytes a
   pixel. */
static int32 triangle_has_maps(const struct material *material, int32 pixel_bytes)
{
    const struct map *const map = material->map, *const light = material->light;

    return map && map->layout == MAP_PAGE && map->texel_bytes == pixel_bytes
        && (material->mapper == MAPPER_AFFINE || (light && light->layout == MAP_LIGHT));
}

/* Returns non-zero if a map that does not repeat is stored as a page. */
static int32 triangle_map_is_page(const struct map *map)
{
    return map && map->layout == MAP_LINEAR && map->texel_bytes == 1 && map->width == MAP_PAGE_SIDE
        && map->height == MAP_PAGE_SIDE && !((uint32)map->texels & 0xffff);
}

enum span_kind triangle_kind(const struct frame *frame, const struct material *material)
{
    const int32 bytes = frame->pixel_bytes;

    if (frame->pitch > TRIANGLE_PITCH_MAX)
        return SPAN_KINDS;
    if (material->mapper == MAPPER_FLAT)
        return bytes == 1 ? SPAN_TRIANGLES_FLAT : bytes == 2 ? SPAN_FILL_16 : SPAN_FILL_32;
    if (material->gradients != GRADIENTS_PLANE || material->start != START_SUBTEXEL
        || material->perspective)
        return SPAN_KINDS;
    if (material->mapper == MAPPER_AFFINE && triangle_has_maps(material, bytes))
        return bytes == 1 ? SPAN_TRIANGLES_AFFINE : bytes == 2 ? SPAN_AFFINE_16 : SPAN_AFFINE_32;
    if (bytes != 1)
        return SPAN_KINDS;
    if (material->mapper == MAPPER_GOURAUD)
        return SPAN_TRIANGLES_GOURAUD;
    if (material->mapper == MAPPER_ARBITRARY && triangle_map_is_page(material->map))
        return SPAN_TRIANGLES_AFFINE;
    if ((material->mapper != MAPPER_LIT && material->mapper != MAPPER_LIT_GOURAUD)
        || !triangle_has_maps(material, 1))
        return SPAN_KINDS;
    return material->mapper == MAPPER_LIT ? SPAN_LIT : SPAN_LIT_GOURAUD;
}
