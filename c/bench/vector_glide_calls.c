#include "bench/vector_glide_calls.h"

#include "bench/vector_answers.h"
#include "bench/vector_file.h"

enum { ARGUMENTS = 258 };       /* of a whole palette */

uint32 vector_sum(uint32 sum, uint32 place, uint32 value)
{
    return sum + value * (2 * place + 1);
}

static void set_texture(struct glide_texture *to, const uint32 *from)
{
    to->largest = from[0];
    to->smallest = from[1];
    to->aspect = from[2];
    to->format = from[3];
}

/* Fills in the texels of a whole map, or none if there is no such map. */
static void fill_texels(uint8 *texels, const struct glide_texture *texture, uint32 seed)
{
    uint32 bytes;

    if (glide_memory_required(GLIDE_BOTH, texture, &bytes) == GLIDE_DONE)
        vector_fill(texels, bytes, seed);
}

static uint32 sum_of_ncc(const struct glide_ncc *values)
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

static enum glide_result call_palette(struct glide *glide, const uint32 *a, uint32 *own)
{
    const enum glide_result result = glide_palette(glide, a[0], a[1], &a[2]);

    for (uint32 n = 0; n < GLIDE_ENTRIES; n++)
        *own = vector_sum(*own, n, glide->palette[n]);
    return result;
}

static enum glide_result call_ncc(struct glide *glide, const uint32 *a, int32 registers, uint32 *own)
{
    struct glide_ncc values;
    enum glide_result result;

    for (int32 n = 0; n < 16; n++)
        values.y[n] = (uint8)a[1 + n];
    for (int32 n = 0; n < 12; n++) {
        values.i[n / 3][n % 3] = (int16)(int32)a[17 + n];
        values.q[n / 3][n % 3] = (int16)(int32)a[29 + n];
    }
    result = registers ? glide_ncc_registers(glide, a[0], &a[1]) : glide_ncc(glide, a[0], &values);
    *own = sum_of_ncc(&glide->ncc[a[0] & 1]);
    return result;
}

static enum glide_result call_chain(struct glide *glide, const uint32 *a)
{
    struct glide *const units[GLIDE_UNITS] = {glide, glide};
    struct glide_chain chain;
    const enum glide_result result = glide_chain_init(&chain, units, a[0]);

    return result == GLIDE_DONE ? glide_chain_hints(&chain, a[1]) : result;
}

enum glide_result vector_glide_call(struct glide *glide, uint32 number, const int32 *values,
                                    uint32 count, uint8 *texels, uint32 *own)
{
    uint32 a[ARGUMENTS];
    struct glide_texture texture;

    for (uint32 i = 0; i < ARGUMENTS; i++)
        a[i] = i < count ? (uint32)values[i] : 0;
    *own = 0;
    switch (number) {
    case VECTOR_GLIDE_CALL_INIT:
        return a[0] > VECTOR_GLIDE_BYTES ? GLIDE_BAD_MEMORY : glide_init(glide, glide->memory, a[0]);
    case VECTOR_GLIDE_CALL_MEMORY_REQUIRED:
        set_texture(&texture, &a[1]);
        return glide_memory_required(a[0], &texture, own);
    case VECTOR_GLIDE_CALL_SOURCE:
        set_texture(&texture, &a[2]);
        return glide_source(glide, a[0], a[1], &texture);
    case VECTOR_GLIDE_CALL_DOWNLOAD:
        set_texture(&texture, &a[2]);
        fill_texels(texels, &texture, a[6]);
        return glide_download(glide, a[0], a[1], &texture, texels);
    case VECTOR_GLIDE_CALL_DOWNLOAD_LEVEL:
        set_texture(&texture, &a[2]);
        fill_texels(texels, &texture, a[7]);
        return glide_download_level(glide, a[0], a[1], &texture, a[6], texels);
    case VECTOR_GLIDE_CALL_DOWNLOAD_ROWS:
        set_texture(&texture, &a[2]);
        fill_texels(texels, &texture, a[9]);
        return glide_download_rows(glide, a[0], a[1], &texture, a[6], a[7], a[8], texels);
    case VECTOR_GLIDE_CALL_PALETTE: return call_palette(glide, a, own);
    case VECTOR_GLIDE_CALL_NCC: return call_ncc(glide, a, 0, own);
    case VECTOR_GLIDE_CALL_NCC_REGISTERS: return call_ncc(glide, a, 1, own);
    case VECTOR_GLIDE_CALL_NCC_SELECT: return glide_ncc_select(glide, a[0]);
    case VECTOR_GLIDE_CALL_FILTER: return glide_filter(glide, a[0], a[1]);
    case VECTOR_GLIDE_CALL_FRACTION_BITS: return glide_fraction_bits(glide, a[0]);
    case VECTOR_GLIDE_CALL_CLAMP: return glide_clamp(glide, a[0], a[1]);
    case VECTOR_GLIDE_CALL_MIPMAP: return glide_mipmap(glide, a[0], a[1]);
    case VECTOR_GLIDE_CALL_BLEND_LEVELS: return glide_blend_levels(glide, a[0]);
    case VECTOR_GLIDE_CALL_LOD_BIAS: return glide_lod_bias(glide, (fix16)a[0]);
    case VECTOR_GLIDE_CALL_DETAIL: return glide_detail(glide, (int32)a[0], a[1], a[2]);
    case VECTOR_GLIDE_CALL_COMBINE:
        return glide_combine(glide, a[0], a[1], a[2], a[3], a[4], a[5]);
    case VECTOR_GLIDE_CALL_PERSPECTIVE: return glide_perspective(glide, a[0], a[1]);
    case VECTOR_GLIDE_CALL_REGISTERS: return glide_registers(glide, a[0], a[1], a[2], a[3]);
    case VECTOR_GLIDE_CALL_SUBDIVISION: return glide_subdivision(glide, a[0]);
    case VECTOR_GLIDE_CALL_CHAIN: return call_chain(glide, a);
    default: return GLIDE_RESULTS;
    }
}
