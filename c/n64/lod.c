/* Level of detail: a pixel's distance to its neighbours in the texture, and the tiles it shows. */
#include "n64/pixel.h"

/* Returns the distance as the hardware does: one less if to - from is negative. */
static int32 distance(int32 from, int32 to)
{
    return to - from < 0 ? ~(to - from) : to - from;
}

static int32 larger(int32 a, int32 b)
{
    return a > b ? a : b;
}

static int32 overflows(const struct n64_divided *at)
{
    return at->overflow_s || at->overflow_t;
}

/* lod: s10.5, 32 is one texel a pixel. far: lod is out of range. */
static void find_level(const struct n64 *n64, int32 lod, int32 far, struct n64_level *level)
{
    const struct n64_modes *modes = &n64->modes;
    int32 magnified = 0, distant = 1, step = 0;

    level->fraction = 0xff;
    if (!far && lod < 32) {
        magnified = 1;
        distant = n64->max_level == 0;
        if (modes->sharpen || modes->detail)
            level->fraction = 8 * larger(lod, n64->min_level) + (modes->sharpen ? 0x100 : 0);
        else
            level->fraction = distant ? 0xff : 0;
    } else if (!far) {
        for (int32 texels = lod >> 5 & 255; texels > 1; texels >>= 1)
            step++;
        distant = n64->max_level == 0 || lod & 0x6000 || step >= n64->max_level;
        if (!distant || modes->sharpen || modes->detail)
            level->fraction = lod * 8 >> step & 255;
    }
    level->tile0 = n64->primitive_tile;
    level->tile1 = n64->primitive_tile + 1;
    if (modes->lod) {
        level->tile0 += distant ? n64->max_level : step;
        level->tile1 = level->tile0;
        if (modes->detail) {
            level->tile0 += magnified ? 0 : 1;
            level->tile1 += distant || magnified ? 1 : 2;
        } else if (!distant && (!magnified || modes->sharpen)) {
            level->tile1++;
        }
    }
    level->tile0 &= 7;
    level->tile1 &= 7;
}

/* mask: clears a gradient's lower bits, which the hardware ignores. */
static void neighbour(const struct n64_iterators *at, const struct n64_iterators *by, uint32 mask,
                      struct n64_iterators *out)
{
    out->s = (int32)((uint32)at->s + ((uint32)by->s & mask));
    out->t = (int32)((uint32)at->t + ((uint32)by->t & mask));
    out->w = (int32)((uint32)at->w + ((uint32)by->w & mask));
}

void n64_level_of_point(const struct n64 *n64, const struct n64_point *point,
                        const struct n64_divided *at, struct n64_level *level)
{
    struct n64_iterators beside;
    struct n64_divided there;
    int32 lod, far;

    neighbour(&point->at, &point->dx, ~(uint32)0x1f, &beside);
    n64_project(n64, &beside, &there);
    lod = larger(distance(at->raw_s, there.raw_s), distance(at->raw_t, there.raw_t));
    far = overflows(at) || overflows(&there);
    if (n64->modes.cycle != N64_ONE_CYCLE) {
        neighbour(&point->at, &point->dy, ~(uint32)0x7fff, &beside);
        n64_project(n64, &beside, &there);
        lod = larger(lod, larger(distance(at->raw_s, there.raw_s),
                                 distance(at->raw_t, there.raw_t)));
        far = far || overflows(&there);
    }
    find_level(n64, lod, far || lod >= 0x4000, level);
}
