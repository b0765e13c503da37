/* Operations of Glide's texture units. */
#include "bench/vector_engines.h"

#include "bench/vector_answers.h"
#include "bench/vector_file.h"
#include "bench/vector_glide_calls.h"
#include "glide/pixel.h"

static struct glide units[GLIDE_UNITS];
static uint8 *memories[GLIDE_UNITS];
static uint8 *texels;           /* room for the texels of a call */
static struct glide *chosen;
static int32 lod;               /* from the gradients */

static void reset(uint32 fraction_bits)
{
    for (int32 n = 0; n < GLIDE_UNITS; n++) {
        uint32 *at = (uint32 *)memories[n];

        for (uint32 longs = VECTOR_GLIDE_BYTES / 4; longs; longs--)
            *at++ = 0;
        glide_init(&units[n], memories[n], VECTOR_GLIDE_BYTES);
        glide_fraction_bits(&units[n], fraction_bits);
        glide_quotients(&units[n], 1);  /* as in the reference data */
    }
    chosen = units;
    lod = GLIDE_LOD_LEAST;
}

void vector_glide_open(uint8 *memory)
{
    for (int32 n = 0; n < GLIDE_UNITS; n++, memory += VECTOR_GLIDE_BYTES)
        memories[n] = memory;
    texels = memory;
    reset(4);
}

static void fill_memory(uint32 seed)
{
    uint8 *at = chosen->memory;

    for (uint32 longs = VECTOR_GLIDE_BYTES / 4; longs; longs--) {
        uint32 value = vector_random(&seed);

        for (int32 n = 0; n < 4; n++, value >>= 8)
            *at++ = (uint8)value;
    }
    chosen->memory_generation++;
}

static void fill_palette(uint32 seed)
{
    uint32 entries[GLIDE_ENTRIES];

    for (int32 n = 0; n < GLIDE_ENTRIES; n++)
        entries[n] = vector_random(&seed);
    glide_palette(chosen, 0, GLIDE_ENTRIES - 1, entries);
}

static void fill_ncc(uint32 seed)
{
    uint32 registers[GLIDE_NCC_REGISTERS];

    for (uint32 table = 0; table < GLIDE_NCC_TABLES; table++) {
        for (int32 n = 0; n < GLIDE_NCC_REGISTERS; n++)
            registers[n] = vector_random(&seed);
        glide_ncc_registers(chosen, table, registers);
    }
}

static void set_point(struct glide_point *point, const int32 *at, const int32 *place)
{
    point->s = at[0];
    point->t = at[1];
    point->w = at[2];
    point->lod = lod;
    point->x = place[0];
    point->y = place[1];
}

static void pixel(const int32 *values)
{
    struct glide_point point;

    set_point(&point, values, &values[4]);
    vector_answer((int32)glide_pixel(chosen, &point, (uint32)values[3]));
}

static void chain_pixel(const int32 *values)
{
    struct glide *const both[GLIDE_UNITS] = {&units[0], &units[1]};
    struct glide_point points[GLIDE_UNITS];
    struct glide_chain chain;
    uint32 colour = 0;

    for (int32 n = 0; n < GLIDE_UNITS; n++)
        set_point(&points[n], &values[2 + 3 * n], &values[8]);
    if (glide_chain_init(&chain, both, (uint32)values[0]) == GLIDE_DONE
        && glide_chain_hints(&chain, (uint32)values[1]) == GLIDE_DONE)
        colour = glide_chain_pixel(&chain, points);
    vector_answer((int32)colour);
}

static void call(const int32 *values, uint32 count)
{
    uint32 registers[4], own;

    vector_answer(vector_glide_call(chosen, (uint32)values[0], &values[1], count - 1, texels,
                                    &own));
    glide_registers_of(chosen, registers);
    for (int32 n = 0; n < 4; n++)
        vector_answer((int32)registers[n]);
    vector_answer((int32)own);
}

static void bytes_of(uint32 address, uint32 longs)
{
    for (; longs; longs--) {
        uint32 value = 0;

        for (int32 n = 0; n < 4; n++)
            value = value << 8 | chosen->memory[address++ & (VECTOR_GLIDE_BYTES - 1)];
        vector_answer((int32)value);
    }
}

static void sum_of_level(uint32 n)
{
    struct glide_level level;
    uint32 place = 0, sum = 0;

    glide_find_level(&chosen->modes, n, &level);
    for (uint32 j = 0; j < level.rows; j++)
        for (uint32 i = 0; i < level.columns; i++)
            sum = vector_sum(sum, place++, glide_texel(chosen, &level, i, j));
    vector_answer((int32)sum);
}

void vector_glide_run(uint32 code, const int32 *values, uint32 count)
{
    switch (code) {
    case VECTOR_GLIDE_RESET: reset((uint32)values[0]); break;
    case VECTOR_GLIDE_CHOOSE: chosen = &units[values[0] & 1]; break;
    case VECTOR_GLIDE_RANDOM: fill_memory((uint32)values[0]); break;
    case VECTOR_GLIDE_PALETTE_RANDOM: fill_palette((uint32)values[0]); break;
    case VECTOR_GLIDE_NCC_RANDOM: fill_ncc((uint32)values[0]); break;
    case VECTOR_GLIDE_REGISTERS:
        glide_registers(chosen, (uint32)values[0], (uint32)values[1], (uint32)values[2],
                        (uint32)values[3]);
        break;
    case VECTOR_GLIDE_GRADIENTS:
        lod = glide_lod_base(values[0], values[1], values[2], values[3]);
        break;
    case VECTOR_GLIDE_PIXEL: pixel(values); break;
    case VECTOR_GLIDE_CHAIN: chain_pixel(values); break;
    case VECTOR_GLIDE_CALL: call(values, count); break;
    case VECTOR_GLIDE_GENERATIONS:
        vector_answer((int32)chosen->memory_generation);
        vector_answer((int32)chosen->table_generation);
        vector_answer((int32)chosen->mode_generation);
        break;
    case VECTOR_GLIDE_BYTES_OF: bytes_of((uint32)values[0], (uint32)values[1]); break;
    case VECTOR_GLIDE_SUM: sum_of_level((uint32)values[0]); break;
    case VECTOR_GLIDE_QUOTIENT: vector_answer(glide_table_quotient(values[0], values[1])); break;
    case VECTOR_GLIDE_LOGARITHM:
        vector_answer(glide_logarithm((uint32)values[0], (uint32)values[1]));
        break;
    case VECTOR_GLIDE_LOD:
        vector_answer(glide_lod_base(values[0], values[1], values[2], values[3]));
        break;
    case VECTOR_GLIDE_RESULT_TEXT:
        vector_answer_text(glide_result_text((enum glide_result)values[0]));
        break;
    }
}
