/* Where a map lies in memory, and its texels' way there. */
#include "tmu/pixel.h"

static enum tmu_result check(uint32 levels, const struct tmu_texture *texture)
{
    if (texture->largest > TMU_LEVEL_LAST || texture->smallest > TMU_LEVEL_LAST)
        return TMU_BAD_LEVEL;
    if (texture->smallest < texture->largest)
        return TMU_BAD_LEVEL_ORDER;
    if (texture->aspect >= TMU_ASPECTS)
        return TMU_BAD_ASPECT;
    if (texture->format >= TMU_FORMATS
        || (texture->format > TMU_P8 && texture->format < TMU_ARGB8332))
        return TMU_BAD_FORMAT;
    if (!levels || levels > TMU_BOTH)
        return TMU_BAD_LEVELS;
    /* One level alone may be of the other kind. */
    if (texture->largest == texture->smallest && !(levels >> (texture->largest & 1) & 1))
        return TMU_NO_LEVEL;
    return TMU_DONE;
}

/* The modes of a map that begins at 0 with level 0; texture and levels are checked. */
static void shape(struct tmu_modes *modes, uint32 levels, const struct tmu_texture *texture)
{
    modes->format = (uint8)texture->format;
    modes->wide = texture->aspect <= TMU_1X1;
    modes->aspect = (uint8)(modes->wide ? TMU_1X1 - texture->aspect : texture->aspect - TMU_1X1);
    modes->split = levels != TMU_BOTH;
    modes->odd = levels == TMU_ODD;
    modes->base = 0;
}

/* Bytes between the start and the first level: base addresses count 8 bytes, and the levels that
   are not there may take 4 more. */
static uint32 gap(const struct tmu_modes *modes, const struct tmu_texture *texture)
{
    return (0 - tmu_level_offset(modes, texture->largest)) & (TMU_START_ALIGN - 1);
}

static uint32 required(const struct tmu_modes *modes, const struct tmu_texture *texture)
{
    const uint32 bytes = tmu_level_offset(modes, texture->smallest + 1)
        - tmu_level_offset(modes, texture->largest) + gap(modes, texture);

    return (bytes + TMU_START_ALIGN - 1) & ~(uint32)(TMU_START_ALIGN - 1);
}

enum tmu_result tmu_memory_required(uint32 levels, const struct tmu_texture *texture,
                                    uint32 *bytes)
{
    const enum tmu_result result = check(levels, texture);
    struct tmu_modes modes;

    if (result == TMU_DONE) {
        shape(&modes, levels, texture);
        *bytes = required(&modes, texture);
    }
    return result;
}

/* The modes become those of a map from start on; all is checked. */
static enum tmu_result place(const struct tmu *tmu, struct tmu_modes *modes, uint32 start,
                             uint32 levels, const struct tmu_texture *texture)
{
    const enum tmu_result result = check(levels, texture);
    uint32 bytes;

    if (result != TMU_DONE)
        return result;
    if (start & (TMU_START_ALIGN - 1))
        return TMU_BAD_START;
    shape(modes, levels, texture);
    bytes = required(modes, texture);
    if (bytes > tmu->memory_bytes || start > tmu->memory_bytes - bytes)
        return TMU_OUTSIDE_MEMORY;
    modes->base = (start + gap(modes, texture) - tmu_level_offset(modes, texture->largest))
        & (tmu->memory_bytes - 1);
    return TMU_DONE;
}

enum tmu_result tmu_source(struct tmu *tmu, uint32 start, uint32 levels,
                           const struct tmu_texture *texture)
{
    struct tmu_modes modes = tmu->modes;
    const enum tmu_result result = place(tmu, &modes, start, levels, texture);

    if (result != TMU_DONE)
        return result;
    tmu_set_modes(tmu, &modes);
    tmu->largest = (uint8)texture->largest;
    tmu->smallest = (uint8)texture->smallest;
    return tmu_mipmap(tmu, tmu->mipmap, modes.trilinear);
}

/* Rows of a level, whose texels are these. */
static void copy(struct tmu *tmu, const struct tmu_modes *modes, uint32 level, uint32 first,
                 uint32 last, const uint8 *texels)
{
    const int32 wide = modes->format >= TMU_ARGB8332;
    const uint32 mask = tmu->memory_bytes - 1;
    struct tmu_level to;
    uint32 address, count;

    tmu_find_level(modes, level, &to);
    address = to.address + (first * to.columns << wide);
    count = (last + 1 - first) * to.columns;
    if (!wide) {
        while (count--)
            tmu->memory[address++ & mask] = *texels++;
        return;
    }
    for (; count; count--, address += 2, texels += 2) {
        tmu->memory[address & mask] = texels[1];
        tmu->memory[(address + 1) & mask] = texels[0];
    }
}

enum tmu_result tmu_download(struct tmu *tmu, uint32 start, uint32 levels,
                             const struct tmu_texture *texture, const void *texels)
{
    const uint8 *from = texels;
    struct tmu_modes modes = tmu->modes;
    const enum tmu_result result = place(tmu, &modes, start, levels, texture);

    if (result != TMU_DONE)
        return result;
    for (uint32 n = texture->largest; n <= texture->smallest; n++) {
        struct tmu_level level;

        tmu_find_level(&modes, n, &level);
        if (tmu_holds(&modes, n))
            copy(tmu, &modes, n, 0, level.rows - 1, from);
        from += level.columns * level.rows << (modes.format >= TMU_ARGB8332);
    }
    tmu->memory_generation++;
    return TMU_DONE;
}

/* As place; the level too. */
static enum tmu_result place_level(const struct tmu *tmu, struct tmu_modes *modes, uint32 start,
                                   uint32 levels, const struct tmu_texture *texture, uint32 level,
                                   struct tmu_level *to)
{
    const enum tmu_result result = place(tmu, modes, start, levels, texture);

    if (result != TMU_DONE)
        return result;
    if (level > TMU_LEVEL_LAST)
        return TMU_BAD_LEVEL;
    tmu_find_level(modes, level, to);
    return TMU_DONE;
}

enum tmu_result tmu_download_rows(struct tmu *tmu, uint32 start, uint32 levels,
                                  const struct tmu_texture *texture, uint32 level,
                                  uint32 first, uint32 last, const void *texels)
{
    struct tmu_modes modes = tmu->modes;
    struct tmu_level to;
    const enum tmu_result result = place_level(tmu, &modes, start, levels, texture, level, &to);

    if (result != TMU_DONE)
        return result;
    if (level < texture->largest || level > texture->smallest || !tmu_holds(&modes, level))
        return TMU_LEVEL_NOT_HELD;
    if (first > last || last >= to.rows)
        return TMU_BAD_ROWS;
    copy(tmu, &modes, level, first, last, texels);
    tmu->memory_generation++;
    return TMU_DONE;
}

enum tmu_result tmu_download_level(struct tmu *tmu, uint32 start, uint32 levels,
                                   const struct tmu_texture *texture, uint32 level,
                                   const void *texels)
{
    struct tmu_modes modes = tmu->modes;
    struct tmu_level to;
    const enum tmu_result result = place_level(tmu, &modes, start, levels, texture, level, &to);

    if (result != TMU_DONE)
        return result;
    return tmu_download_rows(tmu, start, levels, texture, level, 0, to.rows - 1, texels);
}
