/* Level of detail: how far a pixel's neighbours are in the texture, and which tiles it shows. */
#include "tx/pixel.h"

/* As the hardware has it: one off below 0. */
static int32 distance(int32 from, int32 to)
{
    return to - from < 0 ? ~(to - from) : to - from;
}

static int32 larger(int32 a, int32 b)
{
    return a > b ? a : b;
}

static int32 overflows(const struct tx_divided *at)
{
    return at->overflow_s || at->overflow_t;
}

/* lod: s10.5, 32 is one texel a pixel; far: beyond reckoning. */
static void find_level(const struct tx *tx, int32 lod, int32 far, struct tx_level *level)
{
    const struct tx_modes *modes = &tx->modes;
    int32 magnified = 0, distant = 1, step = 0;

    level->fraction = 0xff;
    if (!far && lod < 32) {
        magnified = 1;
        distant = tx->max_level == 0;
        if (modes->sharpen || modes->detail)
            level->fraction = 8 * larger(lod, tx->min_level) + (modes->sharpen ? 0x100 : 0);
        else
            level->fraction = distant ? 0xff : 0;
    } else if (!far) {
        for (int32 texels = lod >> 5 & 255; texels > 1; texels >>= 1)
            step++;
        distant = tx->max_level == 0 || lod & 0x6000 || step >= tx->max_level;
        if (!distant || modes->sharpen || modes->detail)
            level->fraction = lod * 8 >> step & 255;
    }
    level->tile0 = tx->primitive_tile;
    level->tile1 = tx->primitive_tile + 1;
    if (modes->lod) {
        level->tile0 += distant ? tx->max_level : step;
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

/* The lower bits of a gradient do not count. */
static void neighbour(const struct tx_iterators *at, const struct tx_iterators *by, uint32 mask,
                      struct tx_iterators *out)
{
    out->s = (int32)((uint32)at->s + ((uint32)by->s & mask));
    out->t = (int32)((uint32)at->t + ((uint32)by->t & mask));
    out->w = (int32)((uint32)at->w + ((uint32)by->w & mask));
}

void tx_level_of_point(const struct tx *tx, const struct tx_point *point,
                       const struct tx_divided *at, struct tx_level *level)
{
    struct tx_iterators beside;
    struct tx_divided there;
    int32 lod, far;

    neighbour(&point->at, &point->dx, ~(uint32)0x1f, &beside);
    tx_project(tx, &beside, &there);
    lod = larger(distance(at->raw_s, there.raw_s), distance(at->raw_t, there.raw_t));
    far = overflows(at) || overflows(&there);
    if (tx->modes.cycle != TX_ONE_CYCLE) {
        neighbour(&point->at, &point->dy, ~(uint32)0x7fff, &beside);
        tx_project(tx, &beside, &there);
        lod = larger(lod, larger(distance(at->raw_s, there.raw_s),
                                 distance(at->raw_t, there.raw_t)));
        far = far || overflows(&there);
    }
    find_level(tx, lod, far || lod >= 0x4000, level);
}
