/* Changes the state by command words. */
#include "n64/bits.h"
#include "n64/n64.h"

/* Copies other to a part of the state. If they differed, increments its generation and returns
   non-zero. */
static int32 change(void *part, const void *other, uint32 bytes, uint32 *generation)
{
    const uint8 *from = other;
    uint32 changed = 0;
    uint8 *to = part;

    for (; bytes; bytes--, to++, from++) {
        changed |= *to ^ (uint32)*from;
        *to = *from;
    }
    if (changed)
        ++*generation;
    return changed != 0;
}

/* Returns the result for a missing sync if strict and the sync is pending, else N64_DONE. */
static enum n64_result due(const struct n64 *n64, uint32 pending, enum n64_result missing)
{
    return n64->strict && n64->pending & pending ? missing : N64_DONE;
}

static enum n64_result tile_due(const struct n64 *n64, uint32 n)
{
    return n64->pending_tiles >> n & 1 ? due(n64, N64_PENDING_TILE, N64_NO_TILE_SYNC) : N64_DONE;
}

static enum n64_result load(struct n64 *n64, uint32 hi, uint32 lo,
                            enum n64_result (*words)(struct n64 *, uint32, uint32))
{
    enum n64_result result = due(n64, N64_PENDING_LOAD, N64_NO_LOAD_SYNC);

    if (result == N64_DONE)
        result = tile_due(n64, n64_bits(lo, 26, 24));
    return result == N64_DONE ? words(n64, hi, lo) : result;
}

static enum n64_result set_tile(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 n = n64_bits(lo, 26, 24);
    struct n64_tile tile = n64->tiles[n];
    enum n64_result result = tile_due(n64, n);

    if (result != N64_DONE)
        return result;
    tile.format = (uint8)n64_bits(hi, 23, 21);
    tile.size = (uint8)n64_bits(hi, 20, 19);
    tile.line = (uint16)n64_bits(hi, 17, 9);
    tile.tmem = (uint16)n64_bits(hi, 8, 0);
    tile.palette = (uint8)n64_bits(lo, 23, 20);
    tile.t.clamp = (uint8)n64_bits(lo, 19, 19);
    tile.t.mirror = (uint8)n64_bits(lo, 18, 18);
    tile.t.mask = (uint8)n64_bits(lo, 17, 14);
    tile.t.shift = (uint8)n64_bits(lo, 13, 10);
    tile.s.clamp = (uint8)n64_bits(lo, 9, 9);
    tile.s.mirror = (uint8)n64_bits(lo, 8, 8);
    tile.s.mask = (uint8)n64_bits(lo, 7, 4);
    tile.s.shift = (uint8)n64_bits(lo, 3, 0);
    change(&n64->tiles[n], &tile, sizeof tile, &n64->tile_generation[n]);
    return N64_DONE;
}

void n64_set_edges(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 n = n64_bits(lo, 26, 24);
    struct n64_tile tile = n64->tiles[n];

    tile.s.low = (uint16)n64_bits(hi, 23, 12);
    tile.t.low = (uint16)n64_bits(hi, 11, 0);
    tile.s.high = (uint16)n64_bits(lo, 23, 12);
    tile.t.high = (uint16)n64_bits(lo, 11, 0);
    change(&n64->tiles[n], &tile, sizeof tile, &n64->tile_generation[n]);
}

static enum n64_result set_tile_size(struct n64 *n64, uint32 hi, uint32 lo)
{
    enum n64_result result = tile_due(n64, n64_bits(lo, 26, 24));

    if (result == N64_DONE)
        n64_set_edges(n64, hi, lo);
    return result;
}

static enum n64_result set_image(struct n64 *n64, uint32 hi, uint32 lo)
{
    n64->image.format = (uint8)n64_bits(hi, 23, 21);
    n64->image.size = (uint8)n64_bits(hi, 20, 19);
    n64->image.width = (uint16)(n64_bits(hi, 9, 0) + 1);
    n64->image.address = n64_bits(lo, 23, 0);
    return N64_DONE;
}

static enum n64_result set_modes(struct n64 *n64, uint32 hi)
{
    enum n64_result result = due(n64, N64_PENDING_PIPE, N64_NO_PIPE_SYNC);
    struct n64_modes modes;

    if (result != N64_DONE)
        return result;
    modes.cycle = (uint8)n64_bits(hi, 21, 20);
    modes.perspective = (uint8)n64_bits(hi, 19, 19);
    modes.detail = (uint8)n64_bits(hi, 18, 18);
    modes.sharpen = (uint8)n64_bits(hi, 17, 17);
    modes.lod = (uint8)n64_bits(hi, 16, 16);
    modes.tlut = (uint8)n64_bits(hi, 15, 15);
    modes.tlut_type = (uint8)n64_bits(hi, 14, 14);
    modes.quad = (uint8)n64_bits(hi, 13, 13);
    modes.mid = (uint8)n64_bits(hi, 12, 12);
    modes.filter0 = (uint8)n64_bits(hi, 11, 11);
    modes.filter1 = (uint8)n64_bits(hi, 10, 10);
    modes.convert_one = (uint8)n64_bits(hi, 9, 9);
    n64->other_modes = n64_bits(hi, 23, 0);
    if (change(&n64->modes, &modes, sizeof modes, &n64->mode_generation))
        n64_find_inputs(n64);
    return N64_DONE;
}

/* Changes only some bits of the modes' upper word. */
static enum n64_result set_some_modes(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 count = n64_bits(hi, 7, 0) + 1, unshift = n64_bits(hi, 15, 8);
    uint32 mask;

    if (count + unshift > 32)
        return n64->checked ? N64_UNKNOWN_COMMAND : N64_DONE;
    mask = 0xffffffffu >> (32 - count) << (32 - count - unshift);
    return set_modes(n64, (n64->other_modes & ~mask) | (lo & mask));
}

static enum n64_result set_convert(struct n64 *n64, uint32 hi, uint32 lo)
{
    enum n64_result result = due(n64, N64_PENDING_PIPE, N64_NO_PIPE_SYNC);
    int16 k[6];

    if (result != N64_DONE)
        return result;
    k[0] = (int16)n64_signed_9((int32)(n64_bits(hi, 21, 13)));
    k[1] = (int16)n64_signed_9((int32)(n64_bits(hi, 12, 4)));
    k[2] = (int16)n64_signed_9((int32)(n64_bits(hi, 3, 0) << 5 | n64_bits(lo, 31, 27)));
    k[3] = (int16)n64_signed_9((int32)(n64_bits(lo, 26, 18)));
    k[4] = (int16)n64_signed_9((int32)(n64_bits(lo, 17, 9)));
    k[5] = (int16)n64_signed_9((int32)(n64_bits(lo, 8, 0)));
    change(n64->k, k, sizeof k, &n64->mode_generation);
    return N64_DONE;
}

static enum n64_result set_combine(struct n64 *n64, uint32 hi, uint32 lo)
{
    enum n64_result result = due(n64, N64_PENDING_PIPE, N64_NO_PIPE_SYNC);
    struct n64_combine combine;

    if (result != N64_DONE)
        return result;
    combine.rgb[0].a = (uint8)n64_bits(hi, 23, 20);
    combine.rgb[0].b = (uint8)n64_bits(lo, 31, 28);
    combine.rgb[0].c = (uint8)n64_bits(hi, 19, 15);
    combine.rgb[0].d = (uint8)n64_bits(lo, 17, 15);
    combine.alpha[0].a = (uint8)n64_bits(hi, 14, 12);
    combine.alpha[0].b = (uint8)n64_bits(lo, 14, 12);
    combine.alpha[0].c = (uint8)n64_bits(hi, 11, 9);
    combine.alpha[0].d = (uint8)n64_bits(lo, 11, 9);
    combine.rgb[1].a = (uint8)n64_bits(hi, 8, 5);
    combine.rgb[1].b = (uint8)n64_bits(lo, 27, 24);
    combine.rgb[1].c = (uint8)n64_bits(hi, 4, 0);
    combine.rgb[1].d = (uint8)n64_bits(lo, 8, 6);
    combine.alpha[1].a = (uint8)n64_bits(lo, 23, 21);
    combine.alpha[1].b = (uint8)n64_bits(lo, 5, 3);
    combine.alpha[1].c = (uint8)n64_bits(lo, 20, 18);
    combine.alpha[1].d = (uint8)n64_bits(lo, 2, 0);
    if (n64->checked) {
        result = n64_check_combine(&combine);
        if (result != N64_DONE)
            return result;
    }
    if (change(&n64->combine, &combine, sizeof combine, &n64->mode_generation))
        n64_find_inputs(n64);
    return N64_DONE;
}

static void set_byte(struct n64 *n64, uint8 *byte, uint32 value)
{
    const uint8 other = (uint8)value;

    change(byte, &other, 1, &n64->mode_generation);
}

/* R G B A have the same order in memory as in the word. */
static void set_colour(struct n64 *n64, uint8 *colour, uint32 word)
{
    change(colour, &word, sizeof word, &n64->mode_generation);
}

/* No sync is due: these are not modes that pending primitives depend on. */
static enum n64_result set_primitive(struct n64 *n64, uint32 hi, uint32 lo)
{
    set_byte(n64, &n64->min_level, n64_bits(hi, 12, 8));
    set_byte(n64, &n64->primitive_fraction, n64_bits(hi, 7, 0));
    set_colour(n64, n64->primitive, lo);
    return N64_DONE;
}

static enum n64_result set_environment(struct n64 *n64, uint32 lo)
{
    enum n64_result result = due(n64, N64_PENDING_PIPE, N64_NO_PIPE_SYNC);

    if (result == N64_DONE)
        set_colour(n64, n64->environment, lo);
    return result;
}

static enum n64_result set_texture(struct n64 *n64, uint32 hi)
{
    set_byte(n64, &n64->max_level, n64_bits(hi, 13, 11));
    set_byte(n64, &n64->primitive_tile, n64_bits(hi, 10, 8));
    return N64_DONE;
}

static enum n64_result sync(struct n64 *n64, uint32 done)
{
    n64->pending &= (uint8)~done;
    if (done & N64_PENDING_TILE)
        n64->pending_tiles = 0;
    return N64_DONE;
}

enum n64_result n64_command(struct n64 *n64, uint32 hi, uint32 lo)
{
    switch (n64_bits(hi, 29, 24)) {
    case N64_OP_NOTHING:
        return N64_DONE;
    case N64_OP_TEXTURE:
        return set_texture(n64, hi);
    case N64_OP_MODES:
        return set_some_modes(n64, hi, lo);
    case N64_OP_LOAD_SYNC:
        return sync(n64, N64_PENDING_LOAD);
    case N64_OP_PIPE_SYNC:
        return sync(n64, N64_PENDING_PIPE | N64_PENDING_TILE);
    case N64_OP_TILE_SYNC:
        return sync(n64, N64_PENDING_TILE);
    case N64_OP_FULL_SYNC:
        return sync(n64, N64_PENDING_LOAD | N64_PENDING_TILE | N64_PENDING_PIPE);
    case N64_OP_CONVERT:
        return set_convert(n64, hi, lo);
    case N64_OP_OTHER_MODES:
        return set_modes(n64, hi);
    case N64_OP_LOAD_TLUT:
        return load(n64, hi, lo, n64_load_tlut_words);
    case N64_OP_TILE_SIZE:
        return set_tile_size(n64, hi, lo);
    case N64_OP_LOAD_BLOCK:
        return load(n64, hi, lo, n64_load_block_words);
    case N64_OP_LOAD_TILE:
        return load(n64, hi, lo, n64_load_tile_words);
    case N64_OP_TILE:
        return set_tile(n64, hi, lo);
    case N64_OP_PRIMITIVE:
        return set_primitive(n64, hi, lo);
    case N64_OP_ENVIRONMENT:
        return set_environment(n64, lo);
    case N64_OP_COMBINE:
        return set_combine(n64, hi, lo);
    case N64_OP_IMAGE:
        return set_image(n64, hi, lo);
    default:
        return n64->checked ? N64_UNKNOWN_COMMAND : N64_DONE;
    }
}

enum n64_result n64_list_run(struct n64 *n64, const struct n64_word *words, uint32 count)
{
    enum n64_result result = N64_DONE;

    for (uint32 i = 0; i < count && result == N64_DONE; i++) {
        n64->command = i;
        result = n64_command(n64, words[i].hi, words[i].lo);
    }
    return result;
}
