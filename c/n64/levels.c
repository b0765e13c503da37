#include "n64/passes.h"

#define NO_FRACTION (24u << 8)          /* a level's shift that leaves nothing of LOD * 8 */

/* alike: what replaces low if only_blends and both tiles are the same. */
static uint32 blending(const struct n64_level_modes *m, int32 level, int32 distant, int32 magnify,
                       uint32 low, uint32 alike)
{
    int32 first = m->tile, second = m->tile + 1;

    if (m->lod) {
        if (distant)
            level = m->max_level;
        if (m->detail) {
            first += level + !magnify;
            second = m->tile + level + (distant || magnify ? 1 : 2);
        } else {
            first += level;
            second = distant || (magnify && !m->sharpen) ? first : first + 1;
        }
    }
    if (m->only_blends && !((first ^ second) & 7))
        low = alike;
    return (uint32)(first & 7) << 24 | (uint32)(second & 7) << 16 | (low & 0xffff);
}

/* Fills from one power of two of the LOD to the next: the fraction is LOD * 8 >> level. */
static void find_near(uint32 *near, const uint32 *levels)
{
    for (int32 i = 32; i < N64_NEAR_LEVELS; i++) {
        const uint32 of = levels[i >> 5];

        near[i] = (of & 0xffff0000) | (((uint32)i << 3 >> (of >> 8 & 255)) & 255) | (of & 255);
    }
}

void n64_levels_make(struct n64_levels *levels, const struct n64_level_modes *m)
{
    const int32 is_plain = !m->sharpen && !m->detail;
    int32 level = 0;

    levels->far = blending(m, 0, 1, 0, 255, 0);
    for (int32 i = 0; i < 32; i++) {
        const int32 distant = m->max_level == 0, most = i > m->min_level ? i : m->min_level;
        const int32 fraction = is_plain ? (distant ? 255 : 0)
            : 8 * most - (m->sharpen ? 256 : 0);

        levels->near[i] = blending(m, 0, distant, 1, (uint32)fraction, 0);
    }
    levels->levels[0] = 0;
    for (int32 i = 1; i < 512; i++) {
        int32 distant;

        if (!(i & 255))
            level = 0;          /* start again: the logarithm is that of 8 bits */
        if ((i & 255) >> (level + 1))
            level++;
        distant = i >= 256 || m->max_level == 0 || level >= m->max_level;
        levels->levels[i] = blending(m, level, distant, 0,
                                     (uint32)level << 8 | (distant && is_plain ? 255 : 0),
                                     NO_FRACTION);
    }
    find_near(levels->near, levels->levels);
}
