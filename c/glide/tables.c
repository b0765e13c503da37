/* Palette and NCC tables. */
#include "glide/glide.h"

enum glide_result glide_palette(struct glide *glide, uint32 first, uint32 last, const uint32 *entries)
{
    if (first > last || last >= GLIDE_ENTRIES)
        return GLIDE_BAD_ENTRIES;
    for (; first <= last; first++)
        glide->palette[first] = *entries++ & 0xffffff;
    glide->table_generation++;
    return GLIDE_DONE;
}

enum glide_result glide_ncc(struct glide *glide, uint32 table, const struct glide_ncc *values)
{
    struct glide_ncc *to = &glide->ncc[table & 1];

    if (table >= GLIDE_NCC_TABLES)
        return GLIDE_BAD_NCC_TABLE;
    for (int32 n = 0; n < 4; n++)
        for (int32 c = 0; c < 3; c++)
            if (values->i[n][c] < -256 || values->i[n][c] > 255
                || values->q[n][c] < -256 || values->q[n][c] > 255)
                return GLIDE_BAD_NCC_VALUE;
    /* For a struct assignment the compiler would call memcpy. */
    for (int32 n = 0; n < 16; n++)
        to->y[n] = values->y[n];
    for (int32 n = 0; n < 4; n++)
        for (int32 c = 0; c < 3; c++) {
            to->i[n][c] = values->i[n][c];
            to->q[n][c] = values->q[n][c];
        }
    glide->table_generation++;
    return GLIDE_DONE;
}

static void unpack(uint32 word, int16 *channels)
{
    for (uint32 c = 0; c < 3; c++) {
        const uint32 value = word >> (18 - 9 * c) & 0x1ff;

        channels[c] = (int16)((int32)(value ^ 0x100) - 0x100);
    }
}

enum glide_result glide_ncc_registers(struct glide *glide, uint32 table, const uint32 *registers)
{
    struct glide_ncc values;

    for (uint32 n = 0; n < 16; n++)
        values.y[n] = (uint8)(registers[n >> 2] >> (n & 3) * 8);
    for (uint32 n = 0; n < 4; n++) {
        unpack(registers[4 + n], values.i[n]);
        unpack(registers[8 + n], values.q[n]);
    }
    return glide_ncc(glide, table, &values);
}
