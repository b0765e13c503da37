/* Calls that set a unit's modes one by one. */
#include "glide/glide.h"
#include "polygon/key.h"

enum glide_result glide_init(struct glide *glide, uint8 *memory, uint32 bytes)
{
    uint8 *to = (uint8 *)glide;

    if (bytes < GLIDE_START_ALIGN || bytes & (bytes - 1))
        return GLIDE_BAD_MEMORY;
    for (uint32 i = 0; i < sizeof *glide; i++)
        to[i] = 0;
    glide->memory = memory;
    glide->memory_bytes = bytes;
    glide->mipmap = GLIDE_NEAREST;
    glide->modes.wide = 1;
    glide->modes.fraction_bits = 4;
    return glide_combine(glide, GLIDE_LOCAL, GLIDE_FACTOR_ZERO, GLIDE_LOCAL, GLIDE_FACTOR_ZERO, 0, 0);
}

void glide_set_modes(struct glide *glide, const struct glide_modes *modes)
{
    if (key_differs((uint32 *)&glide->modes, (const uint32 *)modes, sizeof *modes / 4))
        glide->mode_generation++;
}

/* Sets a byte of the modes; increments mode_generation if it differed. */
static void set_mode(struct glide *glide, void *field, uint32 value)
{
    uint8 *to = field;

    if (*to != (uint8)value)
        glide->mode_generation++;
    *to = (uint8)value;
}

/* The same if value is `most` at most, else returns `bad`. */
static enum glide_result set_up_to(struct glide *glide, void *field, uint32 value, uint32 most,
                                   enum glide_result bad)
{
    if (value > most)
        return bad;
    set_mode(glide, field, value);
    return GLIDE_DONE;
}

enum glide_result glide_filter(struct glide *glide, uint32 minify, uint32 magnify)
{
    if (minify > GLIDE_BILINEAR || magnify > GLIDE_BILINEAR)
        return GLIDE_BAD_FILTER;
    set_mode(glide, &glide->modes.minify, minify);
    set_mode(glide, &glide->modes.magnify, magnify);
    return GLIDE_DONE;
}

enum glide_result glide_fraction_bits(struct glide *glide, uint32 bits)
{
    if (bits != 4 && bits != 8)
        return GLIDE_BAD_FRACTION_BITS;
    set_mode(glide, &glide->modes.fraction_bits, bits);
    return GLIDE_DONE;
}

enum glide_result glide_quotients(struct glide *glide, uint32 by_table)
{
    return set_up_to(glide, &glide->modes.table_quotients, by_table, 1, GLIDE_BAD_FLAG);
}

enum glide_result glide_subdivision(struct glide *glide, uint32 pixels)
{
    if (pixels && pixels != 8 && pixels != 16)
        return GLIDE_BAD_SUBDIVISION;
    set_mode(glide, &glide->modes.subdivision, pixels);
    return GLIDE_DONE;
}

enum glide_result glide_bilinear_by(struct glide *glide, uint32 dithered)
{
    return set_up_to(glide, &glide->modes.dithered, dithered, 1, GLIDE_BAD_FLAG);
}

enum glide_result glide_clamp(struct glide *glide, uint32 s, uint32 t)
{
    if (s > GLIDE_CLAMP || t > GLIDE_CLAMP)
        return GLIDE_BAD_WRAPPING;
    set_mode(glide, &glide->modes.clamp_s, s);
    set_mode(glide, &glide->modes.clamp_t, t);
    return GLIDE_DONE;
}

enum glide_result glide_mipmap(struct glide *glide, uint32 mode, uint32 lod_blend)
{
    const uint32 smallest = mode == GLIDE_MIPMAP_OFF ? glide->largest : glide->smallest;

    if (mode > GLIDE_NEAREST_DITHER)
        return GLIDE_BAD_MIPMAP;
    if (lod_blend > 1)
        return GLIDE_BAD_FLAG;
    set_mode(glide, &glide->modes.lod_min, (uint32)glide->largest << 2);
    set_mode(glide, &glide->modes.lod_max, smallest << 2);
    set_mode(glide, &glide->modes.dither, mode == GLIDE_NEAREST_DITHER);
    set_mode(glide, &glide->modes.trilinear, lod_blend);
    glide->mipmap = (uint8)mode;
    return GLIDE_DONE;
}

enum glide_result glide_blend_levels(struct glide *glide, uint32 levels)
{
    if (glide->modes.split || (levels != GLIDE_EVEN && levels != GLIDE_ODD))
        return GLIDE_BAD_LEVELS;
    set_mode(glide, &glide->modes.odd, levels == GLIDE_ODD);
    return GLIDE_DONE;
}

enum glide_result glide_lod_bias(struct glide *glide, fix16 bias)
{
    if (bias < -8 * 65536 || bias > 31 * 65536 / 4)
        return GLIDE_BAD_LOD_BIAS;
    set_mode(glide, &glide->modes.lod_bias, (uint32)((bias + 65536 / 8) / (65536 / 4)));
    return GLIDE_DONE;
}

enum glide_result glide_detail(struct glide *glide, int32 bias, uint32 scale, uint32 max)
{
    if (bias < -32 || bias > 31)
        return GLIDE_BAD_DETAIL_BIAS;
    if (scale > 7)
        return GLIDE_BAD_DETAIL_SCALE;
    if (max > 255)
        return GLIDE_BAD_DETAIL_MAX;
    set_mode(glide, &glide->modes.detail_bias, (uint32)bias);
    set_mode(glide, &glide->modes.detail_scale, scale);
    set_mode(glide, &glide->modes.detail_max, max);
    return GLIDE_DONE;
}

enum glide_result glide_perspective(struct glide *glide, uint32 on, uint32 clamp_negative_w)
{
    if (on > 1 || clamp_negative_w > 1)
        return GLIDE_BAD_FLAG;
    set_mode(glide, &glide->modes.perspective, on);
    set_mode(glide, &glide->modes.clamp_negative_w, clamp_negative_w);
    return GLIDE_DONE;
}

enum glide_result glide_ncc_select(struct glide *glide, uint32 table)
{
    return set_up_to(glide, &glide->modes.ncc_table, table, GLIDE_NCC_TABLES - 1,
                     GLIDE_BAD_NCC_TABLE);
}
