/* Operations of Glide's texture units. */
#include "bench/vector_engines.h"

#include "bench/vector_answers.h"
#include "bench/vector_file.h"
#include "bench/vector_tmu_calls.h"
#include "tmu/pixel.h"

static struct tmu units[TMU_UNITS];
static uint8 *memories[TMU_UNITS];
static uint8 *texels;           /* of calls */
static struct tmu *chosen;
static int32 lod;               /* of the gradients */

static void reset(uint32 fraction_bits)
{
    for (int32 n = 0; n < TMU_UNITS; n++) {
        uint32 *at = (uint32 *)memories[n];

        for (uint32 longs = VECTOR_TMU_BYTES / 4; longs; longs--)
            *at++ = 0;
        tmu_init(&units[n], memories[n], VECTOR_TMU_BYTES);
        tmu_fraction_bits(&units[n], fraction_bits);
    }
    chosen = units;
    lod = TMU_LOD_LEAST;
}

void vector_tmu_open(uint8 *memory)
{
    for (int32 n = 0; n < TMU_UNITS; n++, memory += VECTOR_TMU_BYTES)
        memories[n] = memory;
    texels = memory;
    reset(4);
}

static void fill_memory(uint32 seed)
{
    uint8 *at = chosen->memory;

    for (uint32 longs = VECTOR_TMU_BYTES / 4; longs; longs--) {
        uint32 value = vector_random(&seed);

        for (int32 n = 0; n < 4; n++, value >>= 8)
            *at++ = (uint8)value;
    }
    chosen->memory_generation++;
}

static void fill_palette(uint32 seed)
{
    uint32 entries[TMU_ENTRIES];

    for (int32 n = 0; n < TMU_ENTRIES; n++)
        entries[n] = vector_random(&seed);
    tmu_palette(chosen, 0, TMU_ENTRIES - 1, entries);
}

static void fill_ncc(uint32 seed)
{
    uint32 registers[TMU_NCC_REGISTERS];

    for (uint32 table = 0; table < TMU_NCC_TABLES; table++) {
        for (int32 n = 0; n < TMU_NCC_REGISTERS; n++)
            registers[n] = vector_random(&seed);
        tmu_ncc_registers(chosen, table, registers);
    }
}

static void set_point(struct tmu_point *point, const int32 *at, const int32 *place)
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
    struct tmu_point point;

    set_point(&point, values, &values[4]);
    vector_answer((int32)tmu_pixel(chosen, &point, (uint32)values[3]));
}

static void chain_pixel(const int32 *values)
{
    struct tmu *const both[TMU_UNITS] = {&units[0], &units[1]};
    struct tmu_point points[TMU_UNITS];
    struct tmu_chain chain;
    uint32 colour = 0;

    for (int32 n = 0; n < TMU_UNITS; n++)
        set_point(&points[n], &values[2 + 3 * n], &values[8]);
    if (tmu_chain_init(&chain, both, (uint32)values[0]) == TMU_DONE
        && tmu_chain_hints(&chain, (uint32)values[1]) == TMU_DONE)
        colour = tmu_chain_pixel(&chain, points);
    vector_answer((int32)colour);
}

static void call(const int32 *values, uint32 count)
{
    uint32 registers[4], own;

    vector_answer(vector_tmu_call(chosen, (uint32)values[0], &values[1], count - 1, texels,
                                  &own));
    tmu_registers_of(chosen, registers);
    for (int32 n = 0; n < 4; n++)
        vector_answer((int32)registers[n]);
    vector_answer((int32)own);
}

static void bytes_of(uint32 address, uint32 longs)
{
    for (; longs; longs--) {
        uint32 value = 0;

        for (int32 n = 0; n < 4; n++)
            value = value << 8 | chosen->memory[address++ & (VECTOR_TMU_BYTES - 1)];
        vector_answer((int32)value);
    }
}

static void sum_of_level(uint32 n)
{
    struct tmu_level level;
    uint32 place = 0, sum = 0;

    tmu_find_level(&chosen->modes, n, &level);
    for (uint32 j = 0; j < level.rows; j++)
        for (uint32 i = 0; i < level.columns; i++)
            sum = vector_sum(sum, place++, tmu_texel(chosen, &level, i, j));
    vector_answer((int32)sum);
}

void vector_tmu_run(uint32 code, const int32 *values, uint32 count)
{
    switch (code) {
    case VECTOR_TMU_RESET: reset((uint32)values[0]); break;
    case VECTOR_TMU_CHOOSE: chosen = &units[values[0] & 1]; break;
    case VECTOR_TMU_RANDOM: fill_memory((uint32)values[0]); break;
    case VECTOR_TMU_PALETTE_RANDOM: fill_palette((uint32)values[0]); break;
    case VECTOR_TMU_NCC_RANDOM: fill_ncc((uint32)values[0]); break;
    case VECTOR_TMU_REGISTERS:
        tmu_registers(chosen, (uint32)values[0], (uint32)values[1], (uint32)values[2],
                      (uint32)values[3]);
        break;
    case VECTOR_TMU_GRADIENTS:
        lod = tmu_lod_base(values[0], values[1], values[2], values[3]);
        break;
    case VECTOR_TMU_PIXEL: pixel(values); break;
    case VECTOR_TMU_CHAIN: chain_pixel(values); break;
    case VECTOR_TMU_CALL: call(values, count); break;
    case VECTOR_TMU_GENERATIONS:
        vector_answer((int32)chosen->memory_generation);
        vector_answer((int32)chosen->table_generation);
        vector_answer((int32)chosen->mode_generation);
        break;
    case VECTOR_TMU_BYTES_OF: bytes_of((uint32)values[0], (uint32)values[1]); break;
    case VECTOR_TMU_SUM: sum_of_level((uint32)values[0]); break;
    case VECTOR_TMU_QUOTIENT: vector_answer(tmu_quotient(values[0], values[1])); break;
    case VECTOR_TMU_LOGARITHM:
        vector_answer(tmu_logarithm((uint32)values[0], (uint32)values[1]));
        break;
    case VECTOR_TMU_LOD:
        vector_answer(tmu_lod_base(values[0], values[1], values[2], values[3]));
        break;
    case VECTOR_TMU_RESULT_TEXT:
        vector_answer_text(tmu_result_text((enum tmu_result)values[0]));
        break;
    }
}
