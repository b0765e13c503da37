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

enum tmu_result tmu_filter(struct tmu *tmu, uint32 minify, uint32 magnify)
{
    struct tmu_modes modes = tmu->modes;

    if (minify > TMU_BILINEAR || magnify > TMU_BILINEAR)
        return TMU_BAD_FILTER;
    modes.minify = (uint8)minify;
    modes.magnify = (uint8)magnify;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_fraction_bits(struct tmu *tmu, uint32 bits)
{
    struct tmu_modes modes = tmu->modes;

    if (bits != 4 && bits != 8)
        return TMU_BAD_FRACTION_BITS;
    modes.fraction_bits = (uint8)bits;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_quotients(struct tmu *tmu, uint32 by_table)
{
    struct tmu_modes modes = tmu->modes;

    if (by_table > 1)
        return TMU_BAD_FLAG;
    modes.table_quotients = (uint8)by_table;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_subdivision(struct tmu *tmu, uint32 pixels)
{
    struct tmu_modes modes = tmu->modes;

    if (pixels && pixels != 8 && pixels != 16)
        return TMU_BAD_SUBDIVISION;
    modes.subdivision = (uint8)pixels;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_bilinear_by(struct tmu *tmu, uint32 dithered)
{
    struct tmu_modes modes = tmu->modes;

    if (dithered > 1)
        return TMU_BAD_FLAG;
    modes.dithered = (uint8)dithered;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_clamp(struct tmu *tmu, uint32 s, uint32 t)
{
    struct tmu_modes modes = tmu->modes;

    if (s > TMU_CLAMP || t > TMU_CLAMP)
        return TMU_BAD_WRAPPING;
    modes.clamp_s = (uint8)s;
    modes.clamp_t = (uint8)t;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_mipmap(struct tmu *tmu, uint32 mode, uint32 lod_blend)
{
    struct tmu_modes modes = tmu->modes;
    const uint32 smallest = mode == TMU_MIPMAP_OFF ? tmu->largest : tmu->smallest;

    if (mode > TMU_NEAREST_DITHER)
        return TMU_BAD_MIPMAP;
    if (lod_blend > 1)
        return TMU_BAD_FLAG;
    modes.lod_min = (uint8)(tmu->largest << 2);
    modes.lod_max = (uint8)(smallest << 2);
    modes.dither = mode == TMU_NEAREST_DITHER;
    modes.trilinear = (uint8)lod_blend;
    tmu->mipmap = (uint8)mode;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_blend_levels(struct tmu *tmu, uint32 levels)
{
    struct tmu_modes modes = tmu->modes;

    if (modes.split || (levels != TMU_EVEN && levels != TMU_ODD))
        return TMU_BAD_LEVELS;
    modes.odd = levels == TMU_ODD;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_lod_bias(struct tmu *tmu, fix16 bias)
{
    struct tmu_modes modes = tmu->modes;

    if (bias < -8 * 65536 || bias > 31 * 65536 / 4)
        return TMU_BAD_LOD_BIAS;
    modes.lod_bias = (int8)((bias + 65536 / 8) / (65536 / 4));
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_detail(struct tmu *tmu, int32 bias, uint32 scale, uint32 max)
{
    struct tmu_modes modes = tmu->modes;

    if (bias < -32 || bias > 31)
        return TMU_BAD_DETAIL_BIAS;
    if (scale > 7)
        return TMU_BAD_DETAIL_SCALE;
    if (max > 255)
        return TMU_BAD_DETAIL_MAX;
    modes.detail_bias = (int8)bias;
    modes.detail_scale = (uint8)scale;
    modes.detail_max = (uint8)max;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}

enum tmu_result tmu_perspective(struct tmu *tmu, uint32 on, uint32 clamp_negative_w)
{
    struct tmu_modes modes = tmu->modes;

    if (on > 1 || clamp_negative_w > 1)
        return TMU_BAD_FLAG;
    modes.perspective = (uint8)on;
    modes.clamp_negative_w = (uint8)clamp_negative_w;
    tmu_set_modes(tmu, &modes);
    return TMU_DONE;
}
