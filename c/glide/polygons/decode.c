#include "glide/polygons/decode.h"

#include "drawing/page.h"
#include "polygon/key.h"

static uint32 rgba(uint32 argb)
{
    return argb << 8 | argb >> 24;
}

static void find_bytes(struct glide_bytes *bytes, const struct glide *glide)
{
    const uint32 none = rgba(glide_colour(glide, 0));

    for (uint32 i = 0; i < 256; i++) {
        bytes->low[i] = rgba(glide_colour(glide, i));
        if (glide->modes.format >= GLIDE_ARGB8332)
            bytes->high[i] = rgba(glide_colour(glide, i << 8)) ^ none;
    }
}

static void make_texels(uint32 *to, const struct glide *glide, const struct glide_level *level,
                        struct glide_bytes *bytes)
{
    const uint32 mask = glide->memory_bytes - 1;
    const uint8 *memory = glide->memory;
    uint32 address = level->address, left = level->columns * level->rows;

    find_bytes(bytes, glide);
    if (glide->modes.format < GLIDE_ARGB8332)
        for (; left; left--, address++)
            *to++ = bytes->low[memory[address & mask]];
    else
        for (; left; left--, address += 2)
            *to++ = bytes->low[memory[address & mask]] ^ bytes->high[memory[(address + 1) & mask]];
}

static void make_quads(void *to, int32 bits, const uint32 *texels, const struct glide_level *level)
{
    for (uint32 j = 0; j < level->rows; j++) {
        const uint32 first = j * level->columns;
        const uint32 *upper = texels + first;
        const uint32 *lower = texels + ((j + 1) & (level->rows - 1)) * level->columns;

        if (bits == 8)
            glide_quads_8_make((struct glide_quad_8 *)to + first, upper, lower, level->columns);
        else
            glide_quads_make((struct glide_quad *)to + first, upper, lower, level->columns);
    }
}

static uint16 bits_of(uint32 side)
{
    uint16 bits = 0;

    for (; side > 1; side >>= 1)
        bits++;
    return bits;
}

static int32 is_fresh(struct glide_kept *kept, const struct glide *glide, uint32 level)
{
    const struct glide_modes *modes = &glide->modes;
    uint32 key[GLIDE_LEVEL_KEY];

    key[0] = 1 | (uint32)modes->odd << 1 | (uint32)modes->split << 2 | (uint32)modes->wide << 3
        | (uint32)modes->aspect << 4 | (uint32)modes->ncc_table << 8
        | (uint32)(modes->fraction_bits == 8) << 12 | (uint32)modes->format << 16 | level << 24;
    key[1] = modes->base;
    key[2] = glide->memory_generation;
    key[3] = glide->table_generation;
    key[4] = (uint32)glide;
    return !key_differs(kept->key, key, GLIDE_LEVEL_KEY);
}

int32 glide_decode(const struct glide *glide, uint32 level, int32 quads, struct glide_kept *kept,
                   struct glide_bytes *bytes)
{
    const int32 fresh = is_fresh(kept, glide, level);
    struct glide_level at;
    uint32 count;

    if (fresh && (!quads || kept->decoded.quads))
        return 1;
    glide_find_level(&glide->modes, level, &at);
    count = at.columns * at.rows;
    if (!fresh) {
        kept->key[0] = 0;               /* not valid until it is made */
        kept->decoded.quads = 0;
        if (!page_room(&kept->texels, &kept->texels_room, count, sizeof *kept->texels))
            return 0;
        make_texels(kept->texels, glide, &at, bytes);
        kept->decoded.texels = kept->texels;
        kept->decoded.mask_s = (uint16)((at.columns - 1) << 4);
        kept->decoded.mask_t = (uint16)((at.rows - 1) << 4);
        kept->decoded.columns_bits = bits_of(at.columns);
        kept->decoded.rows_bits = bits_of(at.rows);
        is_fresh(kept, glide, level);
    }
    if (!quads)
        return 1;
    if (!page_room(&kept->quads, &kept->quads_room, count, sizeof(struct glide_quad)))
        return 0;
    make_quads(kept->quads, glide->modes.fraction_bits, kept->texels, &at);
    kept->decoded.quads = kept->quads;
    return 1;
}
