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

/* Returns 1 if a texel's coordinate of a vertex is out of range. */
static int32 is_beyond(fix16 value, fix16 scale)
{
    return (uint32)(scale ? mul_round(value, scale) : value) + ((uint32)SNAPPED_TEXELS << 16)
        >= (uint32)SNAPPED_TEXELS << 17;
}

int32 triangle_takes(const struct frame *frame, const struct polygon *polygon, const struct material *material)
{
    const struct vertex *v = polygon->vertices;
    const int32 has_texels = triangle_values(material->mapper) >= VALUES_TEXELS;
    const fix16 scale = triangle_scale(material);
    struct triangle_range range;
    int32 low = 0x7fffffff, high = 0;

    if (polygon->count > TRIANGLE_CORNERS_MAX || material->mapper == MAPPER_ARBITRARY
        || triangle_kind(frame, material) == SPAN_KINDS)
        return 0;
    triangle_range_set(&range, frame);
    for (int32 i = polygon->count; i > 0; i--, v++) {
        const int32 x = (v->x + SNAPPED_HALF) >> (16 - SNAPPED_BITS), y = (v->y + SNAPPED_HALF) >> (16 - SNAPPED_BITS);

        if ((uint32)x > range.right || (uint32)y > range.bottom
            || (has_texels && (is_beyond(v->s, scale) || is_beyond(v->t, scale))))
            return 0;
        low = y < low ? y : low;
        high = y > high ? y : high;
    }
    return high - low < SNAPPED_LINES * SNAPPED_ONE;
}
