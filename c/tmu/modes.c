/* A unit's modes: their change, and the calls that set them one by one. */
#include "tmu/tmu.h"

enum tmu_result tmu_init(struct tmu *tmu, uint8 *memory, uint32 bytes)
{
    uint8 *to = (uint8 *)tmu;

    if (bytes < TMU_START_ALIGN || bytes & (bytes - 1))
        return TMU_BAD_MEMORY;
    for (uint32 i = 0; i < sizeof *tmu; i++)
        to[i] = 0;
    tmu->memory = memory;
    tmu->memory_bytes = bytes;
    tmu->mipmap = TMU_NEAREST;
    tmu->modes.wide = 1;
    tmu->modes.fraction_bits = 4;
    return tmu_combine(tmu, TMU_LOCAL, TMU_FACTOR_ZERO, TMU_LOCAL, TMU_FACTOR_ZERO, 0, 0);
}

void tmu_set_modes(struct tmu *tmu, const struct tmu_modes *modes)
{
    const uint8 *from = (const uint8 *)modes;
    uint8 *to = (uint8 *)&tmu->modes;
    uint32 changed = 0;

    for (uint32 i = 0; i < sizeof *modes; i++) {
        changed |= to[i] ^ (uint32)from[i];
        to[i] = from[i];
    }
    if (changed)
        tmu->mode_generation++;
}

/* One field of them becomes a value, which fits. */
static void set_mode(struct tmu *tmu, void *field, uint32 value)
{
    uint8 *to = field;

    if (*to != (uint8)value)
        tmu->mode_generation++;
    *to = (uint8)value;
}

enum tmu_result tmu_filter(struct tmu *tmu, uint32 minify, uint32 magnify)
{
    if (minify > TMU_BILINEAR || magnify > TMU_BILINEAR)
        return TMU_BAD_FILTER;
    set_mode(tmu, &tmu->modes.minify, minify);
    set_mode(tmu, &tmu->modes.magnify, magnify);
    return TMU_DONE;
}

enum tmu_result tmu_fraction_bits(struct tmu *tmu, uint32 bits)
{
    if (bits != 4 && bits != 8)
        return TMU_BAD_FRACTION_BITS;
    set_mode(tmu, &tmu->modes.fraction_bits, bits);
    return TMU_DONE;
}

enum tmu_result tmu_quotients(struct tmu *tmu, uint32 by_table)
{
    if (by_table > 1)
        return TMU_BAD_FLAG;
    set_mode(tmu, &tmu->modes.table_quotients, by_table);
    return TMU_DONE;
}

enum tmu_result tmu_subdivision(struct tmu *tmu, uint32 pixels)
{
    if (pixels && pixels != 8 && pixels != 16)
        return TMU_BAD_SUBDIVISION;
    set_mode(tmu, &tmu->modes.subdivision, pixels);
    return TMU_DONE;
}

enum tmu_result tmu_bilinear_by(struct tmu *tmu, uint32 dithered)
{
    if (dithered > 1)
        return TMU_BAD_FLAG;
    set_mode(tmu, &tmu->modes.dithered, dithered);
    return TMU_DONE;
}

enum tmu_result tmu_clamp(struct tmu *tmu, uint32 s, uint32 t)
{
    if (s > TMU_CLAMP || t > TMU_CLAMP)
        return TMU_BAD_WRAPPING;
    set_mode(tmu, &tmu->modes.clamp_s, s);
    set_mode(tmu, &tmu->modes.clamp_t, t);
    return TMU_DONE;
}

enum tmu_result tmu_mipmap(struct tmu *tmu, uint32 mode, uint32 lod_blend)
{
    const uint32 smallest = mode == TMU_MIPMAP_OFF ? tmu->largest : tmu->smallest;

    if (mode > TMU_NEAREST_DITHER)
        return TMU_BAD_MIPMAP;
    if (lod_blend > 1)
        return TMU_BAD_FLAG;
    set_mode(tmu, &tmu->modes.lod_min, (uint32)tmu->largest << 2);
    set_mode(tmu, &tmu->modes.lod_max, smallest << 2);
    set_mode(tmu, &tmu->modes.dither, mode == TMU_NEAREST_DITHER);
    set_mode(tmu, &tmu->modes.trilinear, lod_blend);
    tmu->mipmap = (uint8)mode;
    return TMU_DONE;
}

enum tmu_result tmu_blend_levels(struct tmu *tmu, uint32 levels)
{
    if (tmu->modes.split || (levels != TMU_EVEN && levels != TMU_ODD))
        return TMU_BAD_LEVELS;
    set_mode(tmu, &tmu->modes.odd, levels == TMU_ODD);
    return TMU_DONE;
}

enum tmu_result tmu_lod_bias(struct tmu *tmu, fix16 bias)
{
    if (bias < -8 * 65536 || bias > 31 * 65536 / 4)
        return TMU_BAD_LOD_BIAS;
    set_mode(tmu, &tmu->modes.lod_bias, (uint32)((bias + 65536 / 8) / (65536 / 4)));
    return TMU_DONE;
}

enum tmu_result tmu_detail(struct tmu *tmu, int32 bias, uint32 scale, uint32 max)
{
    if (bias < -32 || bias > 31)
        return TMU_BAD_DETAIL_BIAS;
    if (scale > 7)
        return TMU_BAD_DETAIL_SCALE;
    if (max > 255)
        return TMU_BAD_DETAIL_MAX;
    set_mode(tmu, &tmu->modes.detail_bias, (uint32)bias);
    set_mode(tmu, &tmu->modes.detail_scale, scale);
    set_mode(tmu, &tmu->modes.detail_max, max);
    return TMU_DONE;
}

enum tmu_result tmu_perspective(struct tmu *tmu, uint32 on, uint32 clamp_negative_w)
{
    if (on > 1 || clamp_negative_w > 1)
        return TMU_BAD_FLAG;
    set_mode(tmu, &tmu->modes.perspective, on);
    set_mode(tmu, &tmu->modes.clamp_negative_w, clamp_negative_w);
    return TMU_DONE;
}

enum tmu_result tmu_ncc_select(struct tmu *tmu, uint32 table)
{
    if (table >= TMU_NCC_TABLES)
        return TMU_BAD_NCC_TABLE;
    set_mode(tmu, &tmu->modes.ncc_table, table);
    return TMU_DONE;
}
