/* Mip maps, a level for each polygon: the one nearest to a texel a pixel by areas, one of the next two being at most
   twice as far away. Of a polygon with perspective that is its density where 1/w is the geometric mean of those of
   the three corners: along lines of constant w, texels a pixel are a constant times w^3. */
#include "polygon/polygon.h"

#include "math/math.h"

/* Twice an area: number * 4^scale units of 1/65536 by 1/65536, at most half a percent off for triangles that are about
   as high as wide. */
struct area {
    uint32 number;              /* below 2^31 */
    int32 scale;
};

/* Finds the area of a triangle from the values, each with the next behind it, of its corners. */
static void find_area(struct area *area, const fix16 *first, const fix16 *a, const fix16 *b)
{
    int32 ax = (int32)((uint32)a[0] - (uint32)first[0]), ay = (int32)((uint32)a[1] - (uint32)first[1]);
    int32 bx = (int32)((uint32)b[0] - (uint32)first[0]), by = (int32)((uint32)b[1] - (uint32)first[1]);
    uint32 most = fix_magnitude(ax) | fix_magnitude(ay) | fix_magnitude(bx) | fix_magnitude(by);

    for (area->scale = 0; most >> 15; most >>= 4)
        area->scale += 4;
    if (area->scale) {
        ax >>= area->scale;
        ay >>= area->scale;
        bx >>= area->scale;
        by >>= area->scale;
    }
    area->number = fix_magnitude((int16)ax * (int16)by - (int16)bx * (int16)ay);
}

/* Returns 1 if an area, times 4^up, is at most another. */
static int32 is_at_most(uint32 area, int32 up, uint32 other)
{
    if (up >= 0)
        return !area || (up < 16 && area <= other >> 2 * up);
    return !area || up <= -16 || (area - 1) >> -2 * up < other;
}

/* Returns log2 of a page's texels to units of s and t. */
static int32 scale_bits(const struct map *map)
{
    int32 bits = 0;

    for (fix16 scale = map->scale; scale < 65536; scale <<= 1)
        bits--;
    return bits;
}

enum polygon_result polygon_draw_mipmapped(struct renderer *renderer, const struct polygon *polygon,
                                           const struct material *material)
{
    const struct vertex *v = polygon->vertices, *a = v + polygon->count / 3, *b = v + 2 * polygon->count / 3;
    struct area pixels, texels;
    int32 level = 0, up;

    if (polygon->count < 3)
        return POLYGON_FEW;
    find_area(&pixels, &v->x, &a->x, &b->x);
    find_area(&texels, &v->s, &a->s, &b->s);
    up = texels.scale - pixels.scale + scale_bits(material->map);
    while (level < material->levels && !is_at_most(texels.number, up - level, 2 * pixels.number))
        level++;
    return polygon_draw(renderer, polygon, level ? material + material->level_at + level - 1 : material);
}
