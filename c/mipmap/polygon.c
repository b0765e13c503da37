/* Mip maps, a level for each polygon: the one nearest to a texel a pixel by areas, one of the next two being at most
   twice as far away. Of a polygon with perspective that is its density where 1/w is the geometric mean of those of
   the three corners: along lines of constant w, texels a pixel are a constant times w^3. */
#include "polygon/polygon.h"

#include "math/math.h"

/* Returns a difference's magnitude, or one less if it is below 0: as many bits as its word needs. */
static inline uint32 size_of(int32 way)
{
    return (uint32)(way < 0 ? ~way : way);
}

/* Returns twice the area of a triangle from the values, each with the next behind it, of its corners: times 4^scale, in
   units of 1/65536 by 1/65536; below 2^31. At most half a percent off for triangles that are about as high as wide. */
static inline uint32 area_of(const fix16 *first, const fix16 *a, const fix16 *b, int32 *scale)
{
    int32 ax = (int32)((uint32)a[0] - (uint32)first[0]), ay = (int32)((uint32)a[1] - (uint32)first[1]);
    int32 bx = (int32)((uint32)b[0] - (uint32)first[0]), by = (int32)((uint32)b[1] - (uint32)first[1]);
    uint32 most = size_of(ax) | size_of(ay) | size_of(bx) | size_of(by);

    for (; most >> 15; most >>= 4) {
        ax >>= 4;
        ay >>= 4;
        bx >>= 4;
        by >>= 4;
        *scale += 4;
    }
    return fix_magnitude((int16)ax * (int16)by - (int16)bx * (int16)ay);
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
    const int32 count = polygon->count;
    const struct vertex *v = polygon->vertices, *a = v + 1, *b = v + 2;
    uint32 pixels, texels;
    int32 level = 0, up = 0, down = 0;

    if (count < 3)
        return POLYGON_FEW;
    if (count > 4) {
        a = v + count / 3;
        b = v + 2 * count / 3;
    }
    pixels = 2 * area_of(&v->x, &a->x, &b->x, &down);
    texels = area_of(&v->s, &a->s, &b->s, &up);
    up += scale_bits(material->map) - down;
    while (level < material->levels && !is_at_most(texels, up - level, pixels))
        level++;
    return polygon_draw(renderer, polygon, level ? material + material->level_at + level - 1 : material);
}
