/* The modes as registers: each byte of struct glide_modes has a field. */
#include "glide/glide.h"

enum register_index { MODE, LOD, DETAIL, BASE };

#define SIGNED 0x80             /* in bits: a signed field */
#define RESERVED_MODE 0x80000000u

/* In the struct's order. */
static const struct {
    uint8 index, shift, bits;
} fields[] = {
    {MODE, 0, 1}, {MODE, 1, 1}, {MODE, 2, 1},                   /* perspective, filters */
    {MODE, 3, 1}, {MODE, 4, 1}, {MODE, 5, 1},                   /* w, dither, NCC table */
    {MODE, 6, 1}, {MODE, 7, 1}, {MODE, 8, 4},                   /* clamp, format */
    {MODE, 12, 1}, {MODE, 13, 1}, {MODE, 14, 3}, {MODE, 17, 1}, /* rgb: other to reverse */
    {MODE, 18, 1}, {MODE, 19, 1}, {MODE, 20, 1},                /* add, add alpha, invert */
    {MODE, 21, 1}, {MODE, 22, 1}, {MODE, 23, 3}, {MODE, 26, 1}, /* alpha */
    {MODE, 27, 1}, {MODE, 28, 1}, {MODE, 29, 1},
    {MODE, 30, 1},                                              /* trilinear */
    {LOD, 0, 6}, {LOD, 6, 6}, {LOD, 12, 6 | SIGNED},            /* min, max, bias */
    {LOD, 18, 1}, {LOD, 19, 1}, {LOD, 20, 1}, {LOD, 21, 2},     /* odd, split, wide, aspect */
    {DETAIL, 0, 8}, {DETAIL, 8, 6 | SIGNED}, {DETAIL, 14, 3}    /* max, bias, scale */
};

enum { FIELDS = sizeof fields / sizeof *fields };

static uint32 mask(uint32 field)
{
    return (1u << (fields[field].bits & ~SIGNED)) - 1;
}

enum glide_result glide_registers(struct glide *glide, uint32 mode, uint32 lod, uint32 detail,
                                  uint32 base)
{
    struct glide_modes modes = glide->modes;
    uint32 words[BASE];
    uint8 *to = (uint8 *)&modes;

    words[MODE] = mode & ~RESERVED_MODE;
    words[LOD] = lod;
    words[DETAIL] = detail;
    for (uint32 n = 0; n < FIELDS; n++) {
        uint32 *word = &words[fields[n].index], value = *word >> fields[n].shift & mask(n);

        *word ^= value << fields[n].shift;
        if (fields[n].bits & SIGNED && value > mask(n) >> 1)
            value |= ~mask(n);
        to[n] = (uint8)value;
    }
    if (words[MODE] | words[LOD] | words[DETAIL] || base >> 29)
        return GLIDE_BAD_REGISTER;
    if (modes.format >= GLIDE_FORMATS || (modes.format > GLIDE_P8 && modes.format < GLIDE_ARGB8332))
        return GLIDE_BAD_FORMAT;
    if (modes.rgb.mselect > GLIDE_FACTOR_LOD_FRACTION
        || modes.alpha.mselect > GLIDE_FACTOR_LOD_FRACTION)
        return GLIDE_BAD_FACTOR;
    modes.base = base << 3;
    glide_set_modes(glide, &modes);
    return GLIDE_DONE;
}

void glide_registers_of(const struct glide *glide, uint32 *registers)
{
    const uint8 *from = (const uint8 *)&glide->modes;

    registers[MODE] = registers[LOD] = registers[DETAIL] = 0;
    registers[BASE] = glide->modes.base >> 3;
    for (uint32 n = 0; n < FIELDS; n++)
        registers[fields[n].index] |= (from[n] & mask(n)) << fields[n].shift;
}
