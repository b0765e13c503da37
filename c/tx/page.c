#include "tx/page.h"

#include "tx/forms.h"
#include "tx/pixels.h"

enum { SIDE = MAP_PAGE_SIDE };

static int32 period(const struct tx_axis *axis)
{
    int32 bits = axis->mask > 10 ? 10 : axis->mask;

    return 1 << (bits + (axis->mirror ? 1 : 0));
}

/* Copy mode does not clamp; an axis without a mask goes on beyond the tile's edges then. */
static int32 repeats(const struct tx_axis *axis, int32 copy)
{
    return axis->mask && (copy || !axis->clamp);
}

static int32 last_index(const struct tx_axis *axis)
{
    return (axis->high >> 2) - (axis->low >> 2);
}

/* Of an axis that does not repeat: its texels in the middle of the page. */
static int32 first_index(const struct tx_axis *axis)
{
    return (last_index(axis) + 1 - SIDE) >> 1;
}

/* An axis whose first edge lies further within its texel than its last one clamps in the middle
   of one. */
int32 tx_page_window(const struct tx_axis *axis, int32 copy, struct tx_window *window)
{
    if (axis->shift)
        return 0;
    window->first = window->period = 0;
    if (repeats(axis, copy)) {
        window->period = period(axis);
        return window->period <= SIDE;
    }
    window->first = first_index(axis);
    return axis->high >= axis->low && last_index(axis) < SIDE
        && (copy || (axis->low & 3) <= (axis->high & 3));
}

/* For each column or row of a page: its coordinates, s10.5, and the first one that shows the
   same texel. */
struct shown {
    int16 coordinate[SIDE];
    uint16 relative[SIDE];
    uint8 same[SIDE];
};

static void find_shown(struct shown *shown, const struct tx_axis *axis, int32 copy)
{
    static int16 first[1024];
    int32 from = repeats(axis, copy) ? 0 : first_index(axis);

    for (int32 i = 0; i < 1024; i++)
        first[i] = -1;
    for (int32 k = 0; k < SIDE; k++) {
        int32 index = from + k;
        int32 c = (int16)(index * 32 + axis->low * 8);
        struct tx_place place;

        shown->relative[k] = (uint16)tx_relative(axis, c);
        tx_place_column(axis, copy ? (uint32)index : shown->relative[k] >> 5, &place);
        shown->coordinate[k] = (int16)c;
        if (first[place.index & 1023] < 0)
            first[place.index & 1023] = (int16)k;
        shown->same[k] = (uint8)first[place.index & 1023];
    }
}

/* What a page is made with. */
struct making {
    const struct tx *tx;
    int32 tile, pixel_bytes;
    const struct tx_colour *shade;
    const struct tx_decoded *decoded;   /* 0: texels are sampled one by one */
    int32 is_texel;             /* the combiner makes nothing else of texel 0 */
    struct shown columns, rows;
};

static void texel_at(const struct making *m, int32 u, int32 v, struct tx_colour *texel)
{
    const struct tx_decoded *from = m->decoded;
    uint32 colour;

    if (!from) {
        tx_sample(m->tx, m->tile, m->columns.coordinate[u], m->rows.coordinate[v], 0, 0, texel);
        return;
    }
    colour = tx_decoded_texel(from, m->columns.relative[u], m->rows.relative[v]);
    texel->r = (int16)(colour >> 24);
    texel->g = (int16)(colour >> 16 & 255);
    texel->b = (int16)(colour >> 8 & 255);
    texel->a = (int16)(colour & 255);
}

static uint32 colour_at(const struct making *m, int32 u, int32 v)
{
    struct tx_sources sources;

    if (m->decoded && m->is_texel)
        return tx_decoded_texel(m->decoded, m->columns.relative[u], m->rows.relative[v]);
    texel_at(m, u, v, &sources.texel0);
    sources.texel1 = sources.texel0;
    sources.shade = *m->shade;
    sources.fraction = 0;
    return tx_combine_pixel(m->tx, &sources);
}

static uint32 pixel_at(const struct making *m, int32 u, int32 v)
{
    uint32 texels[2];

    if (m->tx->modes.cycle != TX_COPY)
        return tx_pixel_of(colour_at(m, u, v), m->pixel_bytes);
    tx_copy_texels(m->tx, m->tile, m->columns.coordinate[u], m->rows.coordinate[v], texels);
    return texels[0] >> 16;
}

/* A row of 2 or 4 bytes a pixel: its own texels, and those again where they are repeated. */
static void make_row_16(uint16 *row, const struct making *m, int32 v)
{
    for (int32 u = 0; u < SIDE; u++)
        row[u] = m->columns.same[u] < u ? row[m->columns.same[u]] : (uint16)pixel_at(m, u, v);
}

static void make_row_32(uint32 *row, const struct making *m, int32 v)
{
    for (int32 u = 0; u < SIDE; u++)
        row[u] = m->columns.same[u] < u ? row[m->columns.same[u]] : pixel_at(m, u, v);
}

/* page: row 0; rows 128 to 255 lie before it, as in MAP_PAGE. */
static void make_page(uint8 *page, struct making *m)
{
    int32 pitch = SIDE * m->pixel_bytes, copy = m->tx->modes.cycle == TX_COPY;

    find_shown(&m->columns, &m->tx->tiles[m->tile].s, copy);
    find_shown(&m->rows, &m->tx->tiles[m->tile].t, copy);
    for (int32 v = 0; v < SIDE; v++) {
        int32 same = m->rows.same[v];
        uint8 *row = page + (int8)v * pitch;

        if (same < v)
            tx_copy_row((const uint32 *)(page + (int8)same * pitch), (uint32 *)row, pitch / 4);
        else if (m->pixel_bytes == 2)
            make_row_16((uint16 *)row, m, v);
        else
            make_row_32((uint32 *)row, m, v);
    }
}

/* Whether the four copies of all TLUT entries are: of four pixels each reads its own. */
static int32 copies_are_equal(const struct tx *tx)
{
    const uint8 *entry = &tx->tmem[TX_TMEM_BYTES / 2];

    for (int32 i = 0; i < 256; i++, entry += 8)
        for (int32 k = 0; k < 6; k++)
            if (entry[k] != entry[k + 2])
                return 0;
    return 1;
}

/* Whether copy mode's four pixels are four of a page's. */
static int32 are_alike(const struct tx *tx, int32 tile)
{
    return tx->modes.tlut ? copies_are_equal(tx) : tx->tiles[tile].size == TX_16;
}

/* Tiles whose texels are as they are in TMEM are decoded first: that is quicker. YUV's are
   signed. */
static const struct tx_decoded *find_decoded(struct tx_unit *unit, int32 tile)
{
    const struct tx *tx = &unit->tx;
    int32 made;

    if (tx->modes.cycle == TX_COPY || !tx->modes.filter0 || tx->tiles[tile].format == TX_YUV
        || tx_decode(tx, tile, TX_QUADS_NONE, &unit->tiles[tile], &made) != TX_DONE)
        return 0;
    return &unit->tiles[tile].decoded;
}

/* Everything that the page depends on. */
static uint32 packed(const uint8 *colour)
{
    return (uint32)colour[0] << 24 | (uint32)colour[1] << 16 | (uint32)colour[2] << 8 | colour[3];
}

static void find_key(uint32 *key, const struct tx *tx, int32 n, int32 pixel_bytes,
                     const struct tx_colour *shade)
{
    struct tx_tile_key tile;

    tx_tile_key_find(&tile, &tx->tiles[n]);
    key[0] = tx->tmem_generation;
    key[1] = tx->mode_generation;
    key[2] = tile.tile;
    key[3] = tile.s;
    key[4] = tile.t;
    key[5] = packed(tx->primitive);
    key[6] = packed(tx->environment);
    key[7] = (uint32)tx->primitive_fraction << 8 | (uint32)pixel_bytes;
    key[8] = (uint32)shade->r << 16 | (uint32)shade->g;
    key[9] = (uint32)shade->b << 16 | (uint32)shade->a;
}

int32 tx_page_make(struct tx_unit *unit, int32 tile, int32 pixel_bytes,
                   const struct tx_colour *shade)
{
    struct tx_page *page = &unit->page;
    static struct making making;
    struct tx_form form;
    uint32 key[TX_PAGE_KEY], differs = 0;

    find_key(key, &unit->tx, tile, pixel_bytes, shade);
    for (int32 i = 0; i < TX_PAGE_KEY; i++) {
        differs |= key[i] ^ page->key[i];
        page->key[i] = key[i];
    }
    if (!differs)
        return 1;
    page->key[0] = ~key[0];     /* of no use until it is made */
    if (unit->tx.modes.cycle == TX_COPY && !are_alike(&unit->tx, tile))
        return 0;
    if (!page_ready(&page->page, pixel_bytes, unit->memory))
        return 0;
    making.tx = &unit->tx;
    making.tile = tile;
    making.pixel_bytes = pixel_bytes;
    making.shade = shade;
    making.decoded = find_decoded(unit, tile);
    tx_form_find(&form, &unit->tx);
    making.is_texel = !form.any && form.first == TX_FIRST_TEXEL
        && form.second == TX_SECOND_NOTHING;
    make_page((uint8 *)page->page.map.texels, &making);
    page->key[0] = key[0];
    return 1;
}
