/* Places a map in memory and copies its texels there. */
#include "glide/pixel.h"

static enum glide_result check(uint32 levels, const struct glide_texture *texture)
{
    if (texture->largest > GLIDE_LEVEL_LAST || texture->smallest > GLIDE_LEVEL_LAST)
        return GLIDE_BAD_LEVEL;
    if (texture->smallest < texture->largest)
        return GLIDE_BAD_LEVEL_ORDER;
    if (texture->aspect >= GLIDE_ASPECTS)
        return GLIDE_BAD_ASPECT;
    if (texture->format >= GLIDE_FORMATS
        || (texture->format > GLIDE_P8 && texture->format < GLIDE_ARGB8332))
        return GLIDE_BAD_FORMAT;
    if (!levels || levels > GLIDE_BOTH)
        return GLIDE_BAD_LEVELS;
    /* A map of a single level may have none of the named parity. */
    if (texture->largest == texture->smallest && !(levels >> (texture->largest & 1) & 1))
        return GLIDE_NO_LEVEL;
    return GLIDE_DONE;
}

/* Sets the modes for a map that begins at 0 with level 0; texture and levels are checked. */
static void shape(struct glide_modes *modes, uint32 levels, const struct glide_texture *texture)
{
    modes->format = (uint8)texture->format;
    modes->wide = texture->aspect <= GLIDE_1X1;
    modes->aspect = (uint8)(modes->wide ? GLIDE_1X1 - texture->aspect : texture->aspect - GLIDE_1X1);
    modes->split = levels != GLIDE_BOTH;
    modes->odd = levels == GLIDE_ODD;
    modes->base = 0;
}

/* Returns the bytes between the start and the first level. The base address must be a multiple of
   8, but the missing larger levels may take 4 bytes more than a multiple. */
static uint32 gap(const struct glide_modes *modes, const struct glide_texture *texture)
{
    return (0 - glide_level_offset(modes, texture->largest)) & (GLIDE_START_ALIGN - 1);
}

static uint32 required(const struct glide_modes *modes, const struct glide_texture *texture)
{
    const uint32 bytes = glide_level_offset(modes, texture->smallest + 1)
        - glide_level_offset(modes, texture->largest) + gap(modes, texture);

    return (bytes + GLIDE_START_ALIGN - 1) & ~(uint32)(GLIDE_START_ALIGN - 1);
}

enum glide_result glide_memory_required(uint32 levels, const struct glide_texture *texture,
                                        uint32 *bytes)
{
    const enum glide_result result = check(levels, texture);
    struct glide_modes modes;

    if (result == GLIDE_DONE) {
        shape(&modes, levels, texture);
        *bytes = required(&modes, texture);
    }
    return result;
}

/* Checks everything and sets the modes for a map from start on. */
static enum glide_result place(const struct glide *glide, struct glide_modes *modes, uint32 start,
                               uint32 levels, const struct glide_texture *texture)
{
    const enum glide_result result = check(levels, texture);
    uint32 bytes;

    if (result != GLIDE_DONE)
        return result;
    if (start & (GLIDE_START_ALIGN - 1))
        return GLIDE_BAD_START;
    shape(modes, levels, texture);
    bytes = required(modes, texture);
    if (bytes > glide->memory_bytes || start > glide->memory_bytes - bytes)
        return GLIDE_OUTSIDE_MEMORY;
    modes->base = (start + gap(modes, texture) - glide_level_offset(modes, texture->largest))
        & (glide->memory_bytes - 1);
    return GLIDE_DONE;
}

enum glide_result glide_source(struct glide *glide, uint32 start, uint32 levels,
                               const struct glide_texture *texture)
{
    struct glide_modes modes = glide->modes;
    const enum glide_result result = place(glide, &modes, start, levels, texture);

    if (result != GLIDE_DONE)
        return result;
    glide_set_modes(glide, &modes);
    glide->largest = (uint8)texture->largest;
    glide->smallest = (uint8)texture->smallest;
    return glide_mipmap(glide, glide->mipmap, modes.trilinear);
}

/* Copies texels to rows first to last of a level. */
static void copy(struct glide *glide, const struct glide_modes *modes, uint32 level, uint32 first,
                 uint32 last, const uint8 *texels)
{
    const int32 wide = modes->format >= GLIDE_ARGB8332;
    const uint32 mask = glide->memory_bytes - 1;
    struct glide_level to;
    uint32 address, count;

    glide_find_level(modes, level, &to);
    address = to.address + (first * to.columns << wide);
    count = (last + 1 - first) * to.columns;
    if (!wide) {
        while (count--)
            glide->memory[address++ & mask] = *texels++;
        return;
    }
    for (; count; count--, address += 2, texels += 2) {
        glide->memory[address & mask] = texels[1];
        glide->memory[(address + 1) & mask] = texels[0];
    }
}

enum glide_result glide_download(struct glide *glide, uint32 start, uint32 levels,
                                 const struct glide_texture *texture, const void *texels)
{
    const uint8 *from = texels;
    struct glide_modes modes = glide->modes;
    const enum glide_result result = place(glide, &modes, start, levels, texture);

    if (result != GLIDE_DONE)
        return result;
    for (uint32 n = texture->largest; n <= texture->smallest; n++) {
        struct glide_level level;

        glide_find_level(&modes, n, &level);
        if (glide_holds(&modes, n))
            copy(glide, &modes, n, 0, level.rows - 1, from);
        from += level.columns * level.rows << (modes.format >= GLIDE_ARGB8332);
    }
    glide->memory_generation++;
    return GLIDE_DONE;
}

/* Copies rows of a level: first to last, or all. */
static enum glide_result download_part(struct glide *glide, uint32 start, uint32 levels,
                                       const struct glide_texture *texture, uint32 level,
                                       uint32 first, uint32 last, int32 all, const void *texels)
{
    struct glide_modes modes = glide->modes;
    const enum glide_result result = place(glide, &modes, start, levels, texture);
    struct glide_level to;

    if (result != GLIDE_DONE)
        return result;
    if (level > GLIDE_LEVEL_LAST)
        return GLIDE_BAD_LEVEL;
    glide_find_level(&modes, level, &to);
    if (all)
        last = to.rows - 1;
    if (level < texture->largest || level > texture->smallest || !glide_holds(&modes, level))
        return GLIDE_LEVEL_NOT_HELD;
    if (first > last || last >= to.rows)
        return GLIDE_BAD_ROWS;
    copy(glide, &modes, level, first, last, texels);
    glide->memory_generation++;
    return GLIDE_DONE;
}

enum glide_result glide_download_rows(struct glide *glide, uint32 start, uint32 levels,
                                      const struct glide_texture *texture, uint32 level,
                                      uint32 first, uint32 last, const void *texels)
{
    return download_part(glide, start, levels, texture, level, first, last, 0, texels);
}

enum glide_result glide_download_level(struct glide *glide, uint32 start, uint32 levels,
                                       const struct glide_texture *texture, uint32 level,
                                       const void *texels)
{
    return download_part(glide, start, levels, texture, level, 0, 0, 1, texels);
}
