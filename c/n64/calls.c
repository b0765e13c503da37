#include "n64/calls.h"

/* The manual's words have these two bits set. */
#define OPERATION(code) (3u << 30 | (uint32)(code) << 24)

/* Returns a value cut to bits, shifted to its place in a word. */
static uint32 field(uint32 value, uint32 shift, uint32 bits)
{
    return (value & ((1u << bits) - 1)) << shift;
}

static enum n64_result append(struct n64_list *list, uint32 hi, uint32 lo)
{
    if (list->count >= list->room)
        return N64_LIST_FULL;
    list->words[list->count].hi = hi;
    list->words[list->count].lo = lo;
    list->count++;
    return N64_DONE;
}

static int32 has_room(const struct n64_list *list, uint32 pairs)
{
    return list->count <= list->room && list->room - list->count >= pairs;
}

static enum n64_result edges(struct n64_list *list, enum n64_operation operation, uint32 tile,
                             uint32 sl, uint32 tl, uint32 sh, uint32 th)
{
    return append(list, OPERATION(operation) | field(sl, 12, 12) | field(tl, 0, 12),
                  field(tile, 24, 3) | field(sh, 12, 12) | field(th, 0, 12));
}

enum n64_result n64_set_texture_image(struct n64_list *list, uint32 format, uint32 size,
                                      uint32 width, uint32 image)
{
    return append(list, OPERATION(N64_OP_IMAGE) | field(format, 21, 3) | field(size, 19, 2)
                  | field(width - 1, 0, 10), field(image, 0, 24));
}

enum n64_result n64_set_tile(struct n64_list *list, uint32 format, uint32 size, uint32 line,
                             uint32 tmem, uint32 tile, uint32 palette,
                             const struct n64_addressing *t, const struct n64_addressing *s)
{
    return append(list, OPERATION(N64_OP_TILE) | field(format, 21, 3) | field(size, 19, 2)
                  | field(line, 9, 9) | field(tmem, 0, 9),
                  field(tile, 24, 3) | field(palette, 20, 4)
                  | field(t->wrap, 18, 2) | field(t->mask, 14, 4) | field(t->shift, 10, 4)
                  | field(s->wrap, 8, 2) | field(s->mask, 4, 4) | field(s->shift, 0, 4));
}

enum n64_result n64_set_tile_size(struct n64_list *list, uint32 tile, uint32 sl, uint32 tl,
                                  uint32 sh, uint32 th)
{
    return edges(list, N64_OP_TILE_SIZE, tile, sl, tl, sh, th);
}

enum n64_result n64_load_block(struct n64_list *list, uint32 tile, uint32 sl, uint32 tl, uint32 sh,
                               uint32 dxt)
{
    /* A number that is too large, cut to its bits, could look like a valid one. */
    return edges(list, N64_OP_LOAD_BLOCK, tile, sl, tl, sh < 0xfff ? sh : 0xfff, dxt);
}

enum n64_result n64_load_tile(struct n64_list *list, uint32 tile, uint32 sl, uint32 tl, uint32 sh,
                              uint32 th)
{
    return edges(list, N64_OP_LOAD_TILE, tile, sl, tl, sh, th);
}

enum n64_result n64_load_tlut(struct n64_list *list, uint32 tile, uint32 last)
{
    return edges(list, N64_OP_LOAD_TLUT, tile, 0, 0, last << 2, 0);
}

enum n64_result n64_texture(struct n64_list *list, uint32 max_level, uint32 tile)
{
    /* "on", and a scale of 1.0 for s and t; texture engines ignore both. */
    return append(list, OPERATION(N64_OP_TEXTURE) | field(max_level, 11, 3) | field(tile, 8, 3)
                  | 2, 0xffffffff);
}

static enum n64_result modes(struct n64_list *list, uint32 shift, uint32 bits, uint32 value)
{
    return append(list, OPERATION(N64_OP_MODES) | (32 - shift - bits) << 8 | (bits - 1),
                  field(bits == 1 ? value != 0 : value, shift, bits));
}

/* A call that sets modes: their place in the upper word. */
#define MODE_CALL(name, shift, bits) \
    enum n64_result n64_##name(struct n64_list *list, uint32 value) \
    { \
        return modes(list, shift, bits, value); \
    }

MODE_CALL(cycle_type, 20, 2)
MODE_CALL(texture_perspective, 19, 1)
MODE_CALL(texture_detail, 17, 2)
MODE_CALL(texture_lod, 16, 1)
MODE_CALL(texture_lut, 14, 2)
MODE_CALL(texture_filter, 12, 2)
MODE_CALL(texture_convert, 9, 3)

enum n64_result n64_set_convert(struct n64_list *list, const int16 *k)
{
    const uint32 k2 = (uint32)k[2];

    return append(list, OPERATION(N64_OP_CONVERT) | field((uint32)k[0], 13, 9)
                  | field((uint32)k[1], 4, 9) | field(k2 >> 5, 0, 4),
                  field(k2, 27, 5) | field((uint32)k[3], 18, 9) | field((uint32)k[4], 9, 9)
                  | field((uint32)k[5], 0, 9));
}

enum n64_result n64_combine_mode(struct n64_list *list, const struct n64_combine *combine)
{
    const uint8 *codes = &combine->rgb[0].a;
    uint32 words[2] = {0, OPERATION(N64_OP_COMBINE)};

    for (int32 i = 0; i < 16; i++) {
        const struct n64_field *to = &n64_combine_fields[i];

        words[to->shift >> 5] |= field(codes[i], to->shift & 31, to->bits);
    }
    return append(list, words[1], words[0]);
}

enum n64_result n64_prim_colour(struct n64_list *list, uint32 min_level, uint32 fraction,
                                uint32 colour)
{
    return append(list, OPERATION(N64_OP_PRIMITIVE) | field(min_level, 8, 8)
                  | field(fraction, 0, 8), colour);
}

enum n64_result n64_env_colour(struct n64_list *list, uint32 colour)
{
    return append(list, OPERATION(N64_OP_ENVIRONMENT), colour);
}

#define SYNC_CALL(name, operation) \
    enum n64_result n64_##name(struct n64_list *list) \
    { \
        return append(list, OPERATION(operation), 0); \
    }

SYNC_CALL(load_sync, N64_OP_LOAD_SYNC)
SYNC_CALL(tile_sync, N64_OP_TILE_SYNC)
SYNC_CALL(pipe_sync, N64_OP_PIPE_SYNC)
SYNC_CALL(full_sync, N64_OP_FULL_SYNC)

/* Returns the TMEM words of a row. 32-bit and YUV texels have half of their bytes in each half of
   TMEM. */
static uint32 line_of(uint32 format, uint32 size, uint32 texels)
{
    if (size == N64_4)
        return ((texels >> 1) + 7) >> 3;
    return (texels * (size == N64_8 || format == N64_YUV ? 1u : 2u) + 7) >> 3;
}

/* Returns the row's increment for a word of 64 bits, rounded up: 11 fraction bits. */
static uint32 dxt_of(uint32 size, uint32 width)
{
    uint32 words = (width << size) >> 4;

    if (!words)
        words = 1;
    return (2047 + words) / words;
}

/* A load: settings of the image and the load tile, those of the render tile, and the texels that
   this shows. */
struct plan {
    uint32 load_size, size;
    uint32 image_width, load_line, line;
    uint32 sl, tl, sh, th;
};

enum { LOAD_PAIRS = 7, TLUT_PAIRS = 6 };

/* texels: of load_size, of a block. */
static enum n64_result load(struct n64_list *list, const struct n64_texture *texture,
                            const struct plan *plan, int32 is_block, uint32 texels)
{
    const uint32 shift = plan->load_size != plan->size ? 1 : 2;     /* of a tile's columns to 10.2 */

    if (!has_room(list, LOAD_PAIRS))
        return N64_LIST_FULL;
    n64_set_texture_image(list, texture->format, plan->load_size, plan->image_width,
                          texture->image);
    n64_set_tile(list, texture->format, plan->load_size, plan->load_line, texture->tmem,
                 N64_LOAD_TILE, 0, &texture->t, &texture->s);
    n64_load_sync(list);
    if (is_block)
        n64_load_block(list, N64_LOAD_TILE, 0, 0, texels - 1, dxt_of(plan->size, texture->width));
    else
        n64_load_tile(list, N64_LOAD_TILE, plan->sl << shift, plan->tl << 2, plan->sh << shift,
                      plan->th << 2);
    n64_pipe_sync(list);
    n64_set_tile(list, texture->format, plan->size, plan->line, texture->tmem, texture->tile,
                 texture->palette, &texture->t, &texture->s);
    return n64_set_tile_size(list, texture->tile, plan->sl << 2, plan->tl << 2, plan->sh << 2,
                             plan->th << 2);
}

static enum n64_result block(struct n64_list *list, const struct n64_texture *texture, uint32 size)
{
    const uint32 shift = size < N64_16 ? N64_16 - size : 0;    /* log2 of the texels in 16 bits */
    const uint32 texels = texture->width * texture->height + (1u << shift) - 1;
    struct plan plan;

    plan.size = size;
    plan.load_size = size == N64_32 ? N64_32 : N64_16;
    plan.image_width = 1;
    plan.load_line = 0;
    plan.line = line_of(texture->format, size, texture->width);
    plan.sl = plan.tl = 0;
    plan.sh = texture->width - 1;
    plan.th = texture->height - 1;
    return load(list, texture, &plan, 1, texels >> shift);
}

enum n64_result n64_load_texture_block(struct n64_list *list, const struct n64_texture *texture)
{
    return block(list, texture, texture->size);
}

enum n64_result n64_load_texture_block_4b(struct n64_list *list, const struct n64_texture *texture)
{
    return block(list, texture, N64_4);
}

static enum n64_result tile(struct n64_list *list, const struct n64_texture *texture, uint32 size,
                            uint32 load_size)
{
    struct plan plan;

    plan.size = size;
    plan.load_size = load_size;
    plan.image_width = texture->width >> (load_size != size);
    plan.line = plan.load_line = line_of(texture->format, size, texture->sh - texture->sl + 1);
    plan.sl = texture->sl;
    plan.tl = texture->tl;
    plan.sh = texture->sh;
    plan.th = texture->th;
    return load(list, texture, &plan, 0, 0);
}

enum n64_result n64_load_texture_tile(struct n64_list *list, const struct n64_texture *texture)
{
    return tile(list, texture, texture->size, texture->size);
}

enum n64_result n64_load_texture_tile_4b(struct n64_list *list, const struct n64_texture *texture)
{
    return tile(list, texture, N64_4, N64_8);
}

static enum n64_result tlut(struct n64_list *list, uint32 tmem, uint32 entries, uint32 image)
{
    static const struct n64_addressing none;

    if (!has_room(list, TLUT_PAIRS))
        return N64_LIST_FULL;
    n64_set_texture_image(list, N64_RGBA, N64_16, 1, image);
    n64_tile_sync(list);
    n64_set_tile(list, N64_RGBA, N64_4, 0, tmem, N64_LOAD_TILE, 0, &none, &none);
    n64_load_sync(list);
    n64_load_tlut(list, N64_LOAD_TILE, entries - 1);
    n64_pipe_sync(list);
    return N64_DONE;
}

enum n64_result n64_load_tlut_16(struct n64_list *list, uint32 palette, uint32 image)
{
    return tlut(list, N64_HALF_WORDS + 16 * (palette & 15), 16, image);
}

enum n64_result n64_load_tlut_256(struct n64_list *list, uint32 image)
{
    return tlut(list, N64_HALF_WORDS, 256, image);
}
