#include "tmu/decode.h"

#include "polygon/key.h"
#include "system/system.h"

/* A texel is its bytes' entries, exclusive-ored: no bit of its colour comes from both. */
struct bytes {
    uint32 low[256], high[256];
};

static uint32 rgba(uint32 argb)
{
    return argb << 8 | argb >> 24;
}

static void find_bytes(struct bytes *bytes, const struct tmu *tmu)
{
    const uint32 none = rgba(tmu_colour(tmu, 0));

    for (uint32 i = 0; i < 256; i++) {
        bytes->low[i] = rgba(tmu_colour(tmu, i));
        if (tmu->modes.format >= TMU_ARGB8332)
            bytes->high[i] = rgba(tmu_colour(tmu, i << 8)) ^ none;
    }
}

static void make_texels(uint32 *to, const struct tmu *tmu, const struct tmu_level *level)
{
    static struct bytes bytes;
    const uint32 mask = tmu->memory_bytes - 1;
    const uint8 *memory = tmu->memory;
    uint32 address = level->address, left = level->columns * level->rows;

    find_bytes(&bytes, tmu);
    if (tmu->modes.format < TMU_ARGB8332)
        for (; left; left--, address++)
            *to++ = bytes.low[memory[address & mask]];
    else
        for (; left; left--, address += 2)
            *to++ = bytes.low[memory[address & mask]] ^ bytes.high[memory[(address + 1) & mask]];
}

static void make_quads(void *to, int32 bits, const uint32 *texels, const struct tmu_level *level)
{
    struct tmu_quad_8 *quad_8 = to;
    struct tmu_quad *quad = to;

    for (uint32 j = 0; j < level->rows; j++) {
        const uint32 *upper = texels + j * level->columns;
        const uint32 *lower = texels + ((j + 1) & (level->rows - 1)) * level->columns;

        if (bits == 8) {
            tmu_quads_8_make(quad_8, upper, lower, level->columns);
            quad_8 += level->columns;
        } else {
            tmu_quads_make(quad, upper, lower, level->columns);
            quad += level->columns;
        }
    }
}

static uint16 bits_of(uint32 side)
{
    uint16 bits = 0;

    for (; side > 1; side >>= 1)
        bits++;
    return bits;
}

static int32 is_fresh(struct tmu_kept *kept, const struct tmu *tmu, uint32 level)
{
    const struct tmu_modes *modes = &tmu->modes;
    uint32 key[TMU_LEVEL_KEY];

    key[0] = 1 | (uint32)modes->odd << 1 | (uint32)modes->split << 2 | (uint32)modes->wide << 3
        | (uint32)modes->aspect << 4 | (uint32)modes->ncc_table << 8
        | (uint32)(modes->fraction_bits == 8) << 12 | (uint32)modes->format << 16 | level << 24;
    key[1] = modes->base;
    key[2] = tmu->memory_generation;
    key[3] = tmu->table_generation;
    key[4] = (uint32)tmu;
    return !key_differs(kept->key, key, TMU_LEVEL_KEY);
}

static int32 room(void *address, uint32 *has, uint32 count, uint32 size)
{
    if (*has < count)
        *has = mem_take(address, (int32)(count * size), MEMORY_ANY) ? count : 0;
    return *has > 0;
}

int32 tmu_decode(const struct tmu *tmu, uint32 level, int32 quads, struct tmu_kept *kept)
{
    const int32 fresh = is_fresh(kept, tmu, level);
    struct tmu_level at;
    uint32 count;

    if (fresh && (!quads || kept->decoded.quads))
        return 1;
    tmu_find_level(&tmu->modes, level, &at);
    count = at.columns * at.rows;
    if (!fresh) {
        kept->key[0] = 0;               /* of no use until it is made */
        kept->decoded.quads = 0;
        if (!room(&kept->texels, &kept->texels_room, count, sizeof *kept->texels))
            return 0;
        make_texels(kept->texels, tmu, &at);
        kept->decoded.texels = kept->texels;
        kept->decoded.mask_s = (uint16)((at.columns - 1) << 4);
        kept->decoded.mask_t = (uint16)((at.rows - 1) << 4);
        kept->decoded.columns_bits = bits_of(at.columns);
        kept->decoded.rows_bits = bits_of(at.rows);
        is_fresh(kept, tmu, level);
    }
    if (!quads)
        return 1;
    if (!room(&kept->quads, &kept->quads_room, count, sizeof(struct tmu_quad)))
        return 0;
    make_quads(kept->quads, tmu->modes.fraction_bits, kept->texels, &at);
    kept->decoded.quads = kept->quads;
    return 1;
}
