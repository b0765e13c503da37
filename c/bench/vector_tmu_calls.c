#include "bench/vector_tmu_calls.h"

#include "bench/vector_answers.h"
#include "bench/vector_file.h"

enum { ARGUMENTS = 258 };       /* a whole palette */

uint32 vector_sum(uint32 sum, uint32 place, uint32 value)
{
    return sum + value * (2 * place + 1);
}

static void set_texture(struct tmu_texture *to, const uint32 *from)
{
    to->largest = from[0];
    to->smallest = from[1];
    to->aspect = from[2];
    to->format = from[3];
}

/* A whole map's, or none if there is no such map. */
static void fill_texels(uint8 *texels, const struct tmu_texture *texture, uint32 seed)
{
    uint32 bytes;

    if (tmu_memory_required(TMU_BOTH, texture, &bytes) == TMU_DONE)
        vector_fill(texels, bytes, seed);
}

static uint32 sum_of_ncc(const struct tmu_ncc *values)
{
    uint32 place = 0, sum = 0;

    for (int32 n = 0; n < 16; n++)
        sum = vector_sum(sum, place++, values->y[n]);
    for (int32 n = 0; n < 4; n++)
        for (int32 c = 0; c < 3; c++)
            sum = vector_sum(sum, place++, (uint32)values->i[n][c]);
    for (int32 n = 0; n < 4; n++)
        for (int32 c = 0; c < 3; c++)
            sum = vector_sum(sum, place++, (uint32)values->q[n][c]);
    return sum;
}

static enum tmu_result call_palette(struct tmu *tmu, const uint32 *a, uint32 *own)
{
    const enum tmu_result result = tmu_palette(tmu, a[0], a[1], &a[2]);

    for (uint32 n = 0; n < TMU_ENTRIES; n++)
        *own = vector_sum(*own, n, tmu->palette[n]);
    return result;
}

static enum tmu_result call_ncc(struct tmu *tmu, const uint32 *a, int32 registers, uint32 *own)
{
    struct tmu_ncc values;
    enum tmu_result result;

    for (int32 n = 0; n < 16; n++)
        values.y[n] = (uint8)a[1 + n];
    for (int32 n = 0; n < 12; n++) {
        values.i[n / 3][n % 3] = (int16)(int32)a[17 + n];
        values.q[n / 3][n % 3] = (int16)(int32)a[29 + n];
    }
    result = registers ? tmu_ncc_registers(tmu, a[0], &a[1]) : tmu_ncc(tmu, a[0], &values);
    *own = sum_of_ncc(&tmu->ncc[a[0] & 1]);
    return result;
}

static enum tmu_result call_chain(struct tmu *tmu, const uint32 *a)
{
    struct tmu *const units[TMU_UNITS] = {tmu, tmu};
    struct tmu_chain chain;
    const enum tmu_result result = tmu_chain_init(&chain, units, a[0]);

    return result == TMU_DONE ? tmu_chain_hints(&chain, a[1]) : result;
}

enum tmu_result vector_tmu_call(struct tmu *tmu, uint32 number, const int32 *values,
                                uint32 count, uint8 *texels, uint32 *own)
{
    uint32 a[ARGUMENTS];
    struct tmu_texture texture;

    for (uint32 i = 0; i < ARGUMENTS; i++)
        a[i] = i < count ? (uint32)values[i] : 0;
    *own = 0;
    switch (number) {
    case VECTOR_TMU_CALL_INIT:
        return a[0] > VECTOR_TMU_BYTES ? TMU_BAD_MEMORY : tmu_init(tmu, tmu->memory, a[0]);
    case VECTOR_TMU_CALL_MEMORY_REQUIRED:
        set_texture(&texture, &a[1]);
        return tmu_memory_required(a[0], &texture, own);
    case VECTOR_TMU_CALL_SOURCE:
        set_texture(&texture, &a[2]);
        return tmu_source(tmu, a[0], a[1], &texture);
    case VECTOR_TMU_CALL_DOWNLOAD:
        set_texture(&texture, &a[2]);
        fill_texels(texels, &texture, a[6]);
        return tmu_download(tmu, a[0], a[1], &texture, texels);
    case VECTOR_TMU_CALL_DOWNLOAD_LEVEL:
        set_texture(&texture, &a[2]);
        fill_texels(texels, &texture, a[7]);
        return tmu_download_level(tmu, a[0], a[1], &texture, a[6], texels);
    case VECTOR_TMU_CALL_DOWNLOAD_ROWS:
        set_texture(&texture, &a[2]);
        fill_texels(texels, &texture, a[9]);
        return tmu_download_rows(tmu, a[0], a[1], &texture, a[6], a[7], a[8], texels);
    case VECTOR_TMU_CALL_PALETTE: return call_palette(tmu, a, own);
    case VECTOR_TMU_CALL_NCC: return call_ncc(tmu, a, 0, own);
    case VECTOR_TMU_CALL_NCC_REGISTERS: return call_ncc(tmu, a, 1, own);
    case VECTOR_TMU_CALL_NCC_SELECT: return tmu_ncc_select(tmu, a[0]);
    case VECTOR_TMU_CALL_FILTER: return tmu_filter(tmu, a[0], a[1]);
    case VECTOR_TMU_CALL_FRACTION_BITS: return tmu_fraction_bits(tmu, a[0]);
    case VECTOR_TMU_CALL_CLAMP: return tmu_clamp(tmu, a[0], a[1]);
    case VECTOR_TMU_CALL_MIPMAP: return tmu_mipmap(tmu, a[0], a[1]);
    case VECTOR_TMU_CALL_BLEND_LEVELS: return tmu_blend_levels(tmu, a[0]);
    case VECTOR_TMU_CALL_LOD_BIAS: return tmu_lod_bias(tmu, (fix16)a[0]);
    case VECTOR_TMU_CALL_DETAIL: return tmu_detail(tmu, (int32)a[0], a[1], a[2]);
    case VECTOR_TMU_CALL_COMBINE:
        return tmu_combine(tmu, a[0], a[1], a[2], a[3], a[4], a[5]);
    case VECTOR_TMU_CALL_PERSPECTIVE: return tmu_perspective(tmu, a[0], a[1]);
    case VECTOR_TMU_CALL_REGISTERS: return tmu_registers(tmu, a[0], a[1], a[2], a[3]);
    case VECTOR_TMU_CALL_SUBDIVISION: return tmu_subdivision(tmu, a[0]);
    case VECTOR_TMU_CALL_CHAIN: return call_chain(tmu, a);
    default: return TMU_RESULTS;
    }
}
