#include "glide/pixel.h"
#include "glide/product.h"

/* In 1/16 LOD. */
static const uint8 pattern[4][4] = {
    {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}
};

static struct number64 square(int32 value)
{
    return glide_product(fix_magnitude(value), fix_magnitude(value));
}

int32 glide_lod_base(int32 dsdx, int32 dtdx, int32 dsdy, int32 dtdy)
{
    struct number64 most = glide_sum(square(dsdx), square(dtdx));
    const struct number64 y = glide_sum(square(dsdy), square(dtdy));

    if (y.hi > most.hi || (y.hi == most.hi && y.lo > most.lo))
        most = y;
    if (!most.hi && !most.lo)
        return GLIDE_LOD_LEAST;
    /* The sum has 36 fraction bits. Its logarithm is rounded first, then halved towards 0, as in
       the reference data. */
    return (glide_logarithm(most.hi, most.lo) - 36 * GLIDE_LOD_ONE) / 2;
}

int32 glide_dither(int32 x, int32 y)
{
    return pattern[y & 3][x & 3] * (GLIDE_LOD_ONE / 16);
}

/* Returns a pixel's LOD before it is clamped. */
static int32 unclamped(const struct glide *glide, const struct glide_point *point)
{
    int32 lod = point->lod;

    if (glide->modes.perspective) {
        /* A negative w counts like the positive one, as in the reference data. */
        if (!point->w)
            return GLIDE_LOD_MOST;
        lod -= glide_logarithm(0, fix_magnitude(point->w)) - 30 * GLIDE_LOD_ONE;
    }
    lod += glide->modes.lod_bias * (GLIDE_LOD_ONE / 4);
    if (glide->modes.dither)
        lod += glide_dither(point->x, point->y);
    return lod;
}

/* Returns 0 for a level that another unit or another pass blends in: the next smaller one is drawn
   instead. */
static int32 is_drawn(const struct glide_modes *modes, int32 level)
{
    return !(modes->split || modes->trilinear) || (level & 1) == modes->odd;
}

int32 glide_lod_least(const struct glide_modes *modes)
{
    return modes->lod_min * (GLIDE_LOD_ONE / 4);
}

int32 glide_lod_most(const struct glide_modes *modes)
{
    const int32 most = modes->lod_max * (GLIDE_LOD_ONE / 4);

    return most < GLIDE_LEVEL_LAST * GLIDE_LOD_ONE ? most : GLIDE_LEVEL_LAST * GLIDE_LOD_ONE;
}

void glide_lod_at(const struct glide_modes *modes, int32 value, struct glide_lod *lod)
{
    int32 level = value / GLIDE_LOD_ONE;

    lod->value = value;
    lod->odd = level & 1;
    if (!is_drawn(modes, level) && level < GLIDE_LEVEL_LAST)
        level++;
    lod->level = (uint8)level;
    lod->filter = value == glide_lod_least(modes) ? modes->magnify : modes->minify;
}

void glide_find_lod(const struct glide *glide, const struct glide_point *point, struct glide_lod *lod)
{
    const struct glide_modes *modes = &glide->modes;
    const int32 least = glide_lod_least(modes), most = glide_lod_most(modes);
    int32 value = unclamped(glide, point);

    if (value < least)
        value = least;
    if (value > most)
        value = most;
    glide_lod_at(modes, value, lod);
}
