#include "bench/vector_n64_calls.h"

#include "bench/vector_file.h"

enum { ARGUMENTS = 20 };

static void set_addressing(struct n64_addressing *to, const uint32 *from)
{
    to->wrap = from[0];
    to->mask = from[1];
    to->shift = from[2];
}

static void set_texture(struct n64_texture *to, const uint32 *from)
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

static enum n64_result call_tile(struct n64_list *list, const uint32 *a)
{
    struct n64_addressing s, t;

    set_addressing(&t, &a[6]);
    set_addressing(&s, &a[9]);
    return n64_set_tile(list, a[0], a[1], a[2], a[3], a[4], a[5], &t, &s);
}

static enum n64_result call_convert(struct n64_list *list, const uint32 *a)
{
    int16 k[6];

    for (int32 i = 0; i < 6; i++)
        k[i] = (int16)(int32)a[i];
    return n64_set_convert(list, k);
}

static enum n64_result call_combine(struct n64_list *list, const uint32 *a)
{
    struct n64_combine combine;
    uint8 *codes = (uint8 *)&combine;

    for (uint32 i = 0; i < sizeof combine; i++)
        codes[i] = (uint8)a[i];
    return n64_combine_mode(list, &combine);
}

enum n64_result vector_n64_call(struct n64_list *list, uint32 number, const int32 *values,
                                uint32 count)
{
    uint32 a[ARGUMENTS];
    struct n64_texture texture;

    for (uint32 i = 0; i < ARGUMENTS; i++)
        a[i] = i < count ? (uint32)values[i] : 0;
    set_texture(&texture, a);
    switch (number) {
    case VECTOR_CALL_TEXTURE_BLOCK: return n64_load_texture_block(list, &texture);
    case VECTOR_CALL_TEXTURE_BLOCK_4B: return n64_load_texture_block_4b(list, &texture);
    case VECTOR_CALL_TEXTURE_TILE: return n64_load_texture_tile(list, &texture);
    case VECTOR_CALL_TEXTURE_TILE_4B: return n64_load_texture_tile_4b(list, &texture);
    case VECTOR_CALL_TLUT_16: return n64_load_tlut_16(list, a[0], a[1]);
    case VECTOR_CALL_TLUT_256: return n64_load_tlut_256(list, a[0]);
    case VECTOR_CALL_IMAGE: return n64_set_texture_image(list, a[0], a[1], a[2], a[3]);
    case VECTOR_CALL_TILE: return call_tile(list, a);
    case VECTOR_CALL_TILE_SIZE: return n64_set_tile_size(list, a[0], a[1], a[2], a[3], a[4]);
    case VECTOR_CALL_LOAD_BLOCK: return n64_load_block(list, a[0], a[1], a[2], a[3], a[4]);
    case VECTOR_CALL_LOAD_TILE: return n64_load_tile(list, a[0], a[1], a[2], a[3], a[4]);
    case VECTOR_CALL_LOAD_TLUT: return n64_load_tlut(list, a[0], a[1]);
    case VECTOR_CALL_TEXTURE: return n64_texture(list, a[0], a[1]);
    case VECTOR_CALL_CYCLE: return n64_cycle_type(list, a[0]);
    case VECTOR_CALL_PERSPECTIVE: return n64_texture_perspective(list, a[0]);
    case VECTOR_CALL_DETAIL: return n64_texture_detail(list, a[0]);
    case VECTOR_CALL_LOD: return n64_texture_lod(list, a[0]);
    case VECTOR_CALL_LUT: return n64_texture_lut(list, a[0]);
    case VECTOR_CALL_FILTER: return n64_texture_filter(list, a[0]);
    case VECTOR_CALL_CONVERSION: return n64_texture_convert(list, a[0]);
    case VECTOR_CALL_CONVERT: return call_convert(list, a);
    case VECTOR_CALL_COMBINE: return call_combine(list, a);
    case VECTOR_CALL_PRIMITIVE: return n64_prim_colour(list, a[0], a[1], a[2]);
    case VECTOR_CALL_ENVIRONMENT: return n64_env_colour(list, a[0]);
    case VECTOR_CALL_LOAD_SYNC: return n64_load_sync(list);
    case VECTOR_CALL_TILE_SYNC: return n64_tile_sync(list);
    case VECTOR_CALL_PIPE_SYNC: return n64_pipe_sync(list);
    case VECTOR_CALL_FULL_SYNC: return n64_full_sync(list);
    default: return N64_UNKNOWN_COMMAND;
    }
}
