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

/* Returns the result for a missing sync if strict and the operation needs it, else N64_DONE. n: the
   tile that it names. */
static enum n64_result due(const struct n64 *n64, uint32 operation, uint32 n)
{
    const int32 loads = operation == N64_OP_LOAD_TLUT || operation == N64_OP_LOAD_BLOCK
        || operation == N64_OP_LOAD_TILE;
    const int32 sets_modes = operation == N64_OP_CONVERT || operation == N64_OP_OTHER_MODES
        || operation == N64_OP_ENVIRONMENT || operation == N64_OP_COMBINE;

    if (!n64->strict)
        return N64_DONE;
    if (loads && n64->pending & N64_PENDING_LOAD)
        return N64_NO_LOAD_SYNC;
    if ((loads || operation == N64_OP_TILE || operation == N64_OP_TILE_SIZE)
        && n64->pending & N64_PENDING_TILE && n64->pending_tiles >> n & 1)
        return N64_NO_TILE_SYNC;
    return sets_modes && n64->pending & N64_PENDING_PIPE ? N64_NO_PIPE_SYNC : N64_DONE;
}

static void set_tile(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 n = n64_bits(lo, 26, 24);
    struct n64_tile tile = n64->tiles[n];

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

static void set_image(struct n64 *n64, uint32 hi, uint32 lo)
{
    n64->image.format = (uint8)n64_bits(hi, 23, 21);
    n64->image.size = (uint8)n64_bits(hi, 20, 19);
    n64->image.width = (uint16)(n64_bits(hi, 9, 0) + 1);
    n64->image.address = n64_bits(lo, 23, 0);
}

/* After the cycle type the fields of the modes have a bit each, in order. */
static void set_modes(struct n64 *n64, uint32 hi)
{
    uint8 modes[sizeof n64->modes];

    modes[0] = (uint8)n64_bits(hi, 21, 20);
    for (uint32 i = 1; i < sizeof modes; i++)
        modes[i] = hi >> (20 - i) & 1;
    n64->other_modes = n64_bits(hi, 23, 0);
    if (change(&n64->modes, modes, sizeof modes, &n64->mode_generation))
        n64_find_inputs(n64);
}

/* Changes only some bits of the modes' upper word. */
static enum n64_result set_some_modes(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 count = n64_bits(hi, 7, 0) + 1, unshift = n64_bits(hi, 15, 8);
    uint32 mask;

    if (count + unshift > 32)
        return n64->checked ? N64_UNKNOWN_COMMAND : N64_DONE;
    mask = 0xffffffffu >> (32 - count) << (32 - count - unshift) & 0xffffff;
    return n64_command(n64, (uint32)N64_OP_OTHER_MODES << 24 | (n64->other_modes & ~mask)
                       | (lo & mask), 0);
}

static void set_convert(struct n64 *n64, uint32 hi, uint32 lo)
{
    int16 k[6];

    k[0] = (int16)n64_signed_9((int32)(n64_bits(hi, 21, 13)));
    k[1] = (int16)n64_signed_9((int32)(n64_bits(hi, 12, 4)));
    k[2] = (int16)n64_signed_9((int32)(n64_bits(hi, 3, 0) << 5 | n64_bits(lo, 31, 27)));
    k[3] = (int16)n64_signed_9((int32)(n64_bits(lo, 26, 18)));
    k[4] = (int16)n64_signed_9((int32)(n64_bits(lo, 17, 9)));
    k[5] = (int16)n64_signed_9((int32)(n64_bits(lo, 8, 0)));
    change(n64->k, k, sizeof k, &n64->mode_generation);
}

const struct n64_field n64_combine_fields[16] = {
    {52, 4}, {28, 4}, {47, 5}, {15, 3}, {37, 4}, {24, 4}, {32, 5}, {6, 3},      /* R G B */
    {44, 3}, {12, 3}, {41, 3}, {9, 3}, {21, 3}, {3, 3}, {18, 3}, {0, 3}         /* alpha */
};

static enum n64_result set_combine(struct n64 *n64, uint32 hi, uint32 lo)
{
    struct n64_combine combine;
    uint8 *codes = &combine.rgb[0].a;

    for (int32 i = 0; i < 16; i++) {
        const struct n64_field *field = &n64_combine_fields[i];

        codes[i] = (field->shift < 32 ? lo >> field->shift : hi >> (field->shift - 32))
            & ((1u << field->bits) - 1);
    }
    if (n64->checked && n64_check_combine(&combine) != N64_DONE)
        return N64_COMBINE_INPUT;
    if (change(&n64->combine, &combine, sizeof combine, &n64->mode_generation))
        n64_find_inputs(n64);
    return N64_DONE;
}

static void set_byte(struct n64 *n64, uint8 *byte, uint32 value)
{
    const uint8 other = (uint8)value;

    change(byte, &other, 1, &n64->mode_generation);
}

static void set_texture(struct n64 *n64, uint32 hi)
{
    set_byte(n64, &n64->max_level, n64_bits(hi, 13, 11));
    set_byte(n64, &n64->primitive_tile, n64_bits(hi, 10, 8));
}

/* R G B A have the same order in memory as in the word. */
static void set_colour(struct n64 *n64, uint8 *colour, uint32 word)
{
    change(colour, &word, sizeof word, &n64->mode_generation);
}

/* No sync is due: these are not modes that pending primitives depend on. */
static void set_primitive(struct n64 *n64, uint32 hi, uint32 lo)
{
    set_byte(n64, &n64->min_level, n64_bits(hi, 12, 8));
    set_byte(n64, &n64->primitive_fraction, n64_bits(hi, 7, 0));
    set_colour(n64, n64->primitive, lo);
}

static void sync(struct n64 *n64, uint32 done)
{
    n64->pending &= (uint8)~done;
    if (done & N64_PENDING_TILE)
        n64->pending_tiles = 0;
}

enum n64_result n64_command(struct n64 *n64, uint32 hi, uint32 lo)
{
    const uint32 operation = n64_bits(hi, 29, 24);
    const enum n64_result result = due(n64, operation, n64_bits(lo, 26, 24));

    if (result != N64_DONE)
        return result;
    switch (operation) {
    case N64_OP_NOTHING: break;
    case N64_OP_TEXTURE: set_texture(n64, hi); break;
    case N64_OP_MODES: return set_some_modes(n64, hi, lo);
    case N64_OP_LOAD_SYNC: sync(n64, N64_PENDING_LOAD); break;
    case N64_OP_PIPE_SYNC: sync(n64, N64_PENDING_PIPE | N64_PENDING_TILE); break;
    case N64_OP_TILE_SYNC: sync(n64, N64_PENDING_TILE); break;
    case N64_OP_FULL_SYNC: sync(n64, ~(uint32)0); break;
    case N64_OP_CONVERT: set_convert(n64, hi, lo); break;
    case N64_OP_OTHER_MODES: set_modes(n64, hi); break;
    case N64_OP_LOAD_TLUT: return n64_load_tlut_words(n64, hi, lo);
    case N64_OP_TILE_SIZE: n64_set_edges(n64, hi, lo); break;
    case N64_OP_LOAD_BLOCK: return n64_load_block_words(n64, hi, lo);
    case N64_OP_LOAD_TILE: return n64_load_tile_words(n64, hi, lo);
    case N64_OP_TILE: set_tile(n64, hi, lo); break;
    case N64_OP_PRIMITIVE: set_primitive(n64, hi, lo); break;
    case N64_OP_ENVIRONMENT: set_colour(n64, n64->environment, lo); break;
    case N64_OP_COMBINE: return set_combine(n64, hi, lo);
    case N64_OP_IMAGE: set_image(n64, hi, lo); break;
    default: return n64->checked ? N64_UNKNOWN_COMMAND : N64_DONE;
    }
    return N64_DONE;
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
