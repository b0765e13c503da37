/* The store of tiles, shared by all pipes. */
#include "glide/polygons/tiles.h"
#include "system/memory.h"

enum { PIXELS = MAP_PAGE_SIDE * MAP_PAGE_SIDE };

void glide_tile_store_init(struct glide_tile_store *store)
{
    uint8 *bytes = (uint8 *)store;

    for (uint32 i = 0; i < sizeof *store; i++)
        bytes[i] = 0;
}

int32 glide_tiles_room(const struct glide_pipe *pipe, int32 pixel_bytes)
{
    const struct glide_tile_store *store = pipe->tiles;
    uint32 room = pipe->prefilter / (uint32)(PIXELS * pixel_bytes);

    if (store->is_full && room > (uint32)store->count)
        return store->count;
    return room < GLIDE_TILES_MAX ? (int32)room : GLIDE_TILES_MAX;
}

/* Returns non-zero if the result depends on the LOD itself, not only on its level. */
static int32 counts_lod(const struct glide_combination *by)
{
    return by->mselect == GLIDE_FACTOR_DETAIL || by->mselect == GLIDE_FACTOR_LOD_FRACTION;
}

static uint32 *add_unit(uint32 *key, const struct glide *glide, const struct glide_lod *lod)
{
    const uint32 *modes = (const uint32 *)&glide->modes;

    *key++ = (uint32)glide;
    *key++ = glide->memory_generation;
    *key++ = glide->table_generation;
    *key++ = (uint32)lod->level | (uint32)lod->filter << 8 | (uint32)lod->odd << 9
        | (counts_lod(&glide->modes.rgb) || counts_lod(&glide->modes.alpha)
           ? (uint32)lod->value << 16 : 0);
    for (uint32 i = 0; i < sizeof glide->modes / 4; i++)
        *key++ = *modes++;
    return key;
}

/* Makes the cache key of tiles. It has the modes, not their generation, so that tiles remain valid
   if a unit alternates between maps. */
static int32 find_key(uint32 *key, const struct glide_tiling *tiling)
{
    const struct glide_part *part = tiling->plan->parts;
    const struct glide_lod *lod = tiling->lods;
    const uint32 *first = key;

    *key++ = (uint32)tiling->pixel_bytes;
    *key++ = (uint32)tiling->shift;
    for (; part; part = part->upstream)
        key = add_unit(key, part->glide, lod++);
    return (int32)(key - first);
}

static int32 is_of(const struct glide_tile_set *set, const uint32 *key, int32 words)
{
    const uint32 *own = set->key;

    if (words != set->words)
        return 0;
    for (; words > 0; words--)
        if (*key++ != *own++)
            return 0;
    return 1;
}

/* Nothing is made from it any more. */
static void clear(struct glide_tile_store *store, struct glide_tile_set *set)
{
    for (int32 i = 0; i < store->count; i++)
        if (store->tiles[i].set == set)
            store->tiles[i].set = 0;
    set->direct = 0;
}

static struct glide_tile_set *find(struct glide_tile_store *store, const uint32 *key, int32 words)
{
    struct glide_tile_set *oldest = store->sets;

    for (struct glide_tile_set *set = store->sets; set < store->sets + GLIDE_TILE_SETS; set++) {
        if (is_of(set, key, words))
            return set;
        if (set->used < oldest->used)
            oldest = set;
    }
    clear(store, oldest);
    oldest->words = words;
    for (int32 i = 0; i < words; i++)
        oldest->key[i] = key[i];
    return oldest;
}

struct glide_tile_set *glide_tile_set_find(const struct glide_tiling *tiling)
{
    struct glide_tile_store *store = tiling->pipe->tiles;
    uint32 key[GLIDE_TILE_SET_KEY];
    const int32 words = find_key(key, tiling);

    if (!store->last || !is_of(store->last, key, words))
        store->last = find(store, key, words);
    store->last->used = store->now;
    return store->last;
}

struct glide_tile *glide_tile_find(const struct glide_tiling *tiling, int32 s, int32 t)
{
    struct glide_tile *tile = tiling->pipe->tiles->tiles;

    for (int32 left = tiling->pipe->tiles->count; left > 0; left--, tile++)
        if (tile->s == s && tile->t == t && tile->set == tiling->set)
            return tile;
    return 0;
}

static struct glide_tile *make(const struct glide_pipe *pipe, int32 bytes)
{
    struct glide_tile_store *store = pipe->tiles;
    struct glide_tile *tile = &store->tiles[store->count];

    if (store->is_full || store->count == GLIDE_TILES_MAX
        || store->bytes + (uint32)bytes > pipe->prefilter)
        return 0;
    if (!mem_take(&tile->memory, bytes, pipe->memory)) {
        store->is_full = 1;
        return 0;
    }
    tile->bytes = bytes;
    store->bytes += (uint32)bytes;
    store->count++;
    return tile;
}

/* One that shows nothing, or was not drawn from for longest. */
static struct glide_tile *give_up(struct glide_tile_store *store, uint32 now, int32 bytes)
{
    struct glide_tile *found = 0, *tile = store->tiles;

    for (int32 left = store->count; left > 0; left--, tile++) {
        if (tile->bytes < bytes || tile->used == now)
            continue;
        if (!tile->set)
            return tile;
        if (!found || tile->used < found->used)
            found = tile;
    }
    return found;
}

struct glide_tile *glide_tile_take(const struct glide_tiling *tiling, int32 s, int32 t)
{
    const int32 bytes = PIXELS * tiling->pixel_bytes;
    struct glide_tile *tile = make(tiling->pipe, bytes);

    if (!tile)
        tile = give_up(tiling->pipe->tiles, tiling->now, bytes);
    if (!tile)
        return 0;
    tile->set = tiling->set;
    tile->s = s;
    tile->t = t;
    tile->from = tile->end = 0;
    tile->low = MAP_PAGE_SIDE;
    tile->high = -1;
    tile->used = tiling->now;
    return tile;
}
