#include "bench/vector_tx_calls.h"

#include "bench/vector_file.h"

enum { ARGUMENTS = 20 };

static void set_addressing(struct tx_addressing *to, const uint32 *from)
{
    to->wrap = from[0];
    to->mask = from[1];
    to->shift = from[2];
}

static void set_texture(struct tx_texture *to, const uint32 *from)
{
    to->image = from[0];
    to->format = from[1];
    to->size = from[2];
    to->width = from[3];
    to->height = from[4];
    to->sl = from[5];
    to->tl = from[6];
    to->sh = from[7];
    to->th = from[8];
    to->palette = from[9];
    set_addressing(&to->s, &from[10]);
    set_addressing(&to->t, &from[13]);
    to->tmem = from[16];
    to->tile = from[17];
}

static enum tx_result call_tile(struct tx_list *list, const uint32 *a)
{
    struct tx_addressing s, t;

    set_addressing(&t, &a[6]);
    set_addressing(&s, &a[9]);
    return tx_set_tile(list, a[0], a[1], a[2], a[3], a[4], a[5], &t, &s);
}

static enum tx_result call_convert(struct tx_list *list, const uint32 *a)
{
    int16 k[6];

    for (int32 i = 0; i < 6; i++)
        k[i] = (int16)(int32)a[i];
    return tx_set_convert(list, k);
}

static enum tx_result call_combine(struct tx_list *list, const uint32 *a)
{
    struct tx_combine combine;
    uint8 *codes = (uint8 *)&combine;

    for (uint32 i = 0; i < sizeof combine; i++)
        codes[i] = (uint8)a[i];
    return tx_combine_mode(list, &combine);
}

enum tx_result vector_tx_call(struct tx_list *list, uint32 number, const int32 *values,
                              uint32 count)
{
    uint32 a[ARGUMENTS];
    struct tx_texture texture;

    for (uint32 i = 0; i < ARGUMENTS; i++)
        a[i] = i < count ? (uint32)values[i] : 0;
    set_texture(&texture, a);
    switch (number) {
    case VECTOR_CALL_TEXTURE_BLOCK: return tx_load_texture_block(list, &texture);
    case VECTOR_CALL_TEXTURE_BLOCK_4B: return tx_load_texture_block_4b(list, &texture);
    case VECTOR_CALL_TEXTURE_TILE: return tx_load_texture_tile(list, &texture);
    case VECTOR_CALL_TEXTURE_TILE_4B: return tx_load_texture_tile_4b(list, &texture);
    case VECTOR_CALL_TLUT_16: return tx_load_tlut_16(list, a[0], a[1]);
    case VECTOR_CALL_TLUT_256: return tx_load_tlut_256(list, a[0]);
    case VECTOR_CALL_IMAGE: return tx_set_texture_image(list, a[0], a[1], a[2], a[3]);
    case VECTOR_CALL_TILE: return call_tile(list, a);
    case VECTOR_CALL_TILE_SIZE: return tx_set_tile_size(list, a[0], a[1], a[2], a[3], a[4]);
    case VECTOR_CALL_LOAD_BLOCK: return tx_load_block(list, a[0], a[1], a[2], a[3], a[4]);
    case VECTOR_CALL_LOAD_TILE: return tx_load_tile(list, a[0], a[1], a[2], a[3], a[4]);
    case VECTOR_CALL_LOAD_TLUT: return tx_load_tlut(list, a[0], a[1]);
    case VECTOR_CALL_TEXTURE: return tx_texture(list, a[0], a[1]);
    case VECTOR_CALL_CYCLE: return tx_cycle_type(list, a[0]);
    case VECTOR_CALL_PERSPECTIVE: return tx_texture_perspective(list, a[0]);
    case VECTOR_CALL_DETAIL: return tx_texture_detail(list, a[0]);
    case VECTOR_CALL_LOD: return tx_texture_lod(list, a[0]);
    case VECTOR_CALL_LUT: return tx_texture_lut(list, a[0]);
    case VECTOR_CALL_FILTER: return tx_texture_filter(list, a[0]);
    case VECTOR_CALL_CONVERSION: return tx_texture_convert(list, a[0]);
    case VECTOR_CALL_CONVERT: return call_convert(list, a);
    case VECTOR_CALL_COMBINE: return call_combine(list, a);
    case VECTOR_CALL_PRIMITIVE: return tx_prim_colour(list, a[0], a[1], a[2]);
    case VECTOR_CALL_ENVIRONMENT: return tx_env_colour(list, a[0]);
    case VECTOR_CALL_LOAD_SYNC: return tx_load_sync(list);
    case VECTOR_CALL_TILE_SYNC: return tx_tile_sync(list);
    case VECTOR_CALL_PIPE_SYNC: return tx_pipe_sync(list);
    case VECTOR_CALL_FULL_SYNC: return tx_full_sync(list);
    default: return TX_UNKNOWN_COMMAND;
    }
}
