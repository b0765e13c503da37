/* Command words to state. */
#include "tx/bits.h"
#include "tx/tx.h"

/* A part of the state becomes another; whether that changes it: its generation grows then. */
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

/* Strict: what a change of this kind may not find pending. */
static enum tx_result due(const struct tx *tx, uint32 pending, enum tx_result missing)
{
    return tx->strict && tx->pending & pending ? missing : TX_DONE;
}

static enum tx_result tile_due(const struct tx *tx, uint32 n)
{
    return tx->pending_tiles >> n & 1 ? due(tx, TX_PENDING_TILE, TX_NO_TILE_SYNC) : TX_DONE;
}

static enum tx_result load(struct tx *tx, uint32 hi, uint32 lo,
                           enum tx_result (*words)(struct tx *, uint32, uint32))
{
    enum tx_result result = due(tx, TX_PENDING_LOAD, TX_NO_LOAD_SYNC);

    if (result == TX_DONE)
        result = tile_due(tx, tx_bits(lo, 26, 24));
    return result == TX_DONE ? words(tx, hi, lo) : result;
}

static enum tx_result set_tile(struct tx *tx, uint32 hi, uint32 lo)
{
    const uint32 n = tx_bits(lo, 26, 24);
    struct tx_tile tile = tx->tiles[n];
    enum tx_result result = tile_due(tx, n);

    if (result != TX_DONE)
        return result;
    tile.format = (uint8)tx_bits(hi, 23, 21);
    tile.size = (uint8)tx_bits(hi, 20, 19);
    tile.line = (uint16)tx_bits(hi, 17, 9);
    tile.tmem = (uint16)tx_bits(hi, 8, 0);
    tile.palette = (uint8)tx_bits(lo, 23, 20);
    tile.t.clamp = (uint8)tx_bits(lo, 19, 19);
    tile.t.mirror = (uint8)tx_bits(lo, 18, 18);
    tile.t.mask = (uint8)tx_bits(lo, 17, 14);
    tile.t.shift = (uint8)tx_bits(lo, 13, 10);
    tile.s.clamp = (uint8)tx_bits(lo, 9, 9);
    tile.s.mirror = (uint8)tx_bits(lo, 8, 8);
    tile.s.mask = (uint8)tx_bits(lo, 7, 4);
    tile.s.shift = (uint8)tx_bits(lo, 3, 0);
    change(&tx->tiles[n], &tile, sizeof tile, &tx->tile_generation[n]);
    return TX_DONE;
}

void tx_set_edges(struct tx *tx, uint32 hi, uint32 lo)
{
    const uint32 n = tx_bits(lo, 26, 24);
    struct tx_tile tile = tx->tiles[n];

    tile.s.low = (uint16)tx_bits(hi, 23, 12);
    tile.t.low = (uint16)tx_bits(hi, 11, 0);
    tile.s.high = (uint16)tx_bits(lo, 23, 12);
    tile.t.high = (uint16)tx_bits(lo, 11, 0);
    change(&tx->tiles[n], &tile, sizeof tile, &tx->tile_generation[n]);
}

static enum tx_result set_tile_size(struct tx *tx, uint32 hi, uint32 lo)
{
    enum tx_result result = tile_due(tx, tx_bits(lo, 26, 24));

    if (result == TX_DONE)
        tx_set_edges(tx, hi, lo);
    return result;
}

static enum tx_result set_image(struct tx *tx, uint32 hi, uint32 lo)
{
    tx->image.format = (uint8)tx_bits(hi, 23, 21);
    tx->image.size = (uint8)tx_bits(hi, 20, 19);
    tx->image.width = (uint16)(tx_bits(hi, 9, 0) + 1);
    tx->image.address = tx_bits(lo, 23, 0);
    return TX_DONE;
}

static enum tx_result set_modes(struct tx *tx, uint32 hi)
{
    enum tx_result result = due(tx, TX_PENDING_PIPE, TX_NO_PIPE_SYNC);
    struct tx_modes modes;

    if (result != TX_DONE)
        return result;
    modes.cycle = (uint8)tx_bits(hi, 21, 20);
    modes.perspective = (uint8)tx_bits(hi, 19, 19);
    modes.detail = (uint8)tx_bits(hi, 18, 18);
    modes.sharpen = (uint8)tx_bits(hi, 17, 17);
    modes.lod = (uint8)tx_bits(hi, 16, 16);
    modes.tlut = (uint8)tx_bits(hi, 15, 15);
    modes.tlut_type = (uint8)tx_bits(hi, 14, 14);
    modes.quad = (uint8)tx_bits(hi, 13, 13);
    modes.mid = (uint8)tx_bits(hi, 12, 12);
    modes.filter0 = (uint8)tx_bits(hi, 11, 11);
    modes.filter1 = (uint8)tx_bits(hi, 10, 10);
    modes.convert_one = (uint8)tx_bits(hi, 9, 9);
    tx->other_modes = tx_bits(hi, 23, 0);
    if (change(&tx->modes, &modes, sizeof modes, &tx->mode_generation))
        tx_find_inputs(tx);
    return TX_DONE;
}

/* Some bits of the modes' upper word; the others stay. */
static enum tx_result set_some_modes(struct tx *tx, uint32 hi, uint32 lo)
{
    const uint32 count = tx_bits(hi, 7, 0) + 1, unshift = tx_bits(hi, 15, 8);
    uint32 mask;

    if (count + unshift > 32)
        return tx->checked ? TX_UNKNOWN_COMMAND : TX_DONE;
    mask = 0xffffffffu >> (32 - count) << (32 - count - unshift);
    return set_modes(tx, (tx->other_modes & ~mask) | (lo & mask));
}

static enum tx_result set_convert(struct tx *tx, uint32 hi, uint32 lo)
{
    enum tx_result result = due(tx, TX_PENDING_PIPE, TX_NO_PIPE_SYNC);
    int16 k[6];

    if (result != TX_DONE)
        return result;
    k[0] = (int16)tx_signed_9((int32)(tx_bits(hi, 21, 13)));
    k[1] = (int16)tx_signed_9((int32)(tx_bits(hi, 12, 4)));
    k[2] = (int16)tx_signed_9((int32)(tx_bits(hi, 3, 0) << 5 | tx_bits(lo, 31, 27)));
    k[3] = (int16)tx_signed_9((int32)(tx_bits(lo, 26, 18)));
    k[4] = (int16)tx_signed_9((int32)(tx_bits(lo, 17, 9)));
    k[5] = (int16)tx_signed_9((int32)(tx_bits(lo, 8, 0)));
    change(tx->k, k, sizeof k, &tx->mode_generation);
    return TX_DONE;
}

static enum tx_result set_combine(struct tx *tx, uint32 hi, uint32 lo)
{
    enum tx_result result = due(tx, TX_PENDING_PIPE, TX_NO_PIPE_SYNC);
    struct tx_combine combine;

    if (result != TX_DONE)
        return result;
    combine.rgb[0].a = (uint8)tx_bits(hi, 23, 20);
    combine.rgb[0].b = (uint8)tx_bits(lo, 31, 28);
    combine.rgb[0].c = (uint8)tx_bits(hi, 19, 15);
    combine.rgb[0].d = (uint8)tx_bits(lo, 17, 15);
    combine.alpha[0].a = (uint8)tx_bits(hi, 14, 12);
    combine.alpha[0].b = (uint8)tx_bits(lo, 14, 12);
    combine.alpha[0].c = (uint8)tx_bits(hi, 11, 9);
    combine.alpha[0].d = (uint8)tx_bits(lo, 11, 9);
    combine.rgb[1].a = (uint8)tx_bits(hi, 8, 5);
    combine.rgb[1].b = (uint8)tx_bits(lo, 27, 24);
    combine.rgb[1].c = (uint8)tx_bits(hi, 4, 0);
    combine.rgb[1].d = (uint8)tx_bits(lo, 8, 6);
    combine.alpha[1].a = (uint8)tx_bits(lo, 23, 21);
    combine.alpha[1].b = (uint8)tx_bits(lo, 5, 3);
    combine.alpha[1].c = (uint8)tx_bits(lo, 20, 18);
    combine.alpha[1].d = (uint8)tx_bits(lo, 2, 0);
    if (tx->checked) {
        result = tx_check_combine(&combine);
        if (result != TX_DONE)
            return result;
    }
    if (change(&tx->combine, &combine, sizeof combine, &tx->mode_generation))
        tx_find_inputs(tx);
    return TX_DONE;
}

static void set_byte(struct tx *tx, uint8 *byte, uint32 value)
{
    const uint8 other = (uint8)value;

    change(byte, &other, 1, &tx->mode_generation);
}

/* R G B A lie in memory as in the word. */
static void set_colour(struct tx *tx, uint8 *colour, uint32 word)
{
    change(colour, &word, sizeof word, &tx->mode_generation);
}

/* Not of the modes that pending primitives were given with: no sync is due. */
static enum tx_result set_primitive(struct tx *tx, uint32 hi, uint32 lo)
{
    set_byte(tx, &tx->min_level, tx_bits(hi, 12, 8));
    set_byte(tx, &tx->primitive_fraction, tx_bits(hi, 7, 0));
    set_colour(tx, tx->primitive, lo);
    return TX_DONE;
}

static enum tx_result set_environment(struct tx *tx, uint32 lo)
{
    enum tx_result result = due(tx, TX_PENDING_PIPE, TX_NO_PIPE_SYNC);

    if (result == TX_DONE)
        set_colour(tx, tx->environment, lo);
    return result;
}

static enum tx_result set_texture(struct tx *tx, uint32 hi)
{
    set_byte(tx, &tx->max_level, tx_bits(hi, 13, 11));
    set_byte(tx, &tx->primitive_tile, tx_bits(hi, 10, 8));
    return TX_DONE;
}

static enum tx_result sync(struct tx *tx, uint32 done)
{
    tx->pending &= (uint8)~done;
    if (done & TX_PENDING_TILE)
        tx->pending_tiles = 0;
    return TX_DONE;
}

enum tx_result tx_command(struct tx *tx, uint32 hi, uint32 lo)
{
    switch (tx_bits(hi, 29, 24)) {
    case TX_OP_NOTHING:
        return TX_DONE;
    case TX_OP_TEXTURE:
        return set_texture(tx, hi);
    case TX_OP_MODES:
        return set_some_modes(tx, hi, lo);
    case TX_OP_LOAD_SYNC:
        return sync(tx, TX_PENDING_LOAD);
    case TX_OP_PIPE_SYNC:
        return sync(tx, TX_PENDING_PIPE | TX_PENDING_TILE);
    case TX_OP_TILE_SYNC:
        return sync(tx, TX_PENDING_TILE);
    case TX_OP_FULL_SYNC:
        return sync(tx, TX_PENDING_LOAD | TX_PENDING_TILE | TX_PENDING_PIPE);
    case TX_OP_CONVERT:
        return set_convert(tx, hi, lo);
    case TX_OP_OTHER_MODES:
        return set_modes(tx, hi);
    case TX_OP_LOAD_TLUT:
        return load(tx, hi, lo, tx_load_tlut_words);
    case TX_OP_TILE_SIZE:
        return set_tile_size(tx, hi, lo);
    case TX_OP_LOAD_BLOCK:
        return load(tx, hi, lo, tx_load_block_words);
    case TX_OP_LOAD_TILE:
        return load(tx, hi, lo, tx_load_tile_words);
    case TX_OP_TILE:
        return set_tile(tx, hi, lo);
    case TX_OP_PRIMITIVE:
        return set_primitive(tx, hi, lo);
    case TX_OP_ENVIRONMENT:
        return set_environment(tx, lo);
    case TX_OP_COMBINE:
        return set_combine(tx, hi, lo);
    case TX_OP_IMAGE:
        return set_image(tx, hi, lo);
    default:
        return tx->checked ? TX_UNKNOWN_COMMAND : TX_DONE;
    }
}

enum tx_result tx_list_run(struct tx *tx, const struct tx_word *words, uint32 count)
{
    enum tx_result result = TX_DONE;

    for (uint32 i = 0; i < count && result == TX_DONE; i++) {
        tx->command = i;
        result = tx_command(tx, words[i].hi, words[i].lo);
    }
    return result;
}
