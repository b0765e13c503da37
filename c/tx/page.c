#include "tx/page.h"

#include "system/system.h"
#include "tx/pixels.h"

enum { SIDE = MAP_PAGE_SIDE };

static int32 period(const struct tx_axis *axis)
{
    int32 bits = axis->mask > 10 ? 10 : axis->mask;

    return 1 << (bits + (axis->mirror ? 1 : 0));
}

static int32 clamps(const struct tx_axis *axis)
{
    return axis->clamp || !axis->mask;
}

static int32 last_index(const struct tx_axis *axis)
{
    return (axis->high >> 2) - (axis->low >> 2);
}

/* Of a clamping axis: its texels in the middle of the page. */
static int32 first_index(const struct tx_axis *axis)
{
    return (last_index(axis) + 1 - SIDE) >> 1;
}

/* An axis whose first edge lies further within its texel than its last one clamps in the middle
   of one. */
int32 tx_page_window(const struct tx_axis *axis, struct tx_window *window)
{
    if (axis->shift)
        return 0;
    if (!clamps(axis)) {
        window->low = -0x7fffffff;
        window->high = 0x7fffffff;
        return period(axis) <= SIDE;
    }
    window->low = first_index(axis) * 65536;
    window->high = window->low + SIDE * 65536;
    return axis->high >= axis->low && (axis->low & 3) <= (axis->high & 3)
        && last_index(axis) < SIDE;
}

/* For each column or row of a page: its coordinate, s10.5, and the first one that shows the
   same texel. */
struct shown {
    int16 coordinate[SIDE];
    uint8 same[SIDE];
};

static void find_shown(struct shown *shown, const struct tx_axis *axis)
{
    static int16 first[1024];
    int32 from = clamps(axis) ? first_index(axis) : 0;

    for (int32 i = 0; i < 1024; i++)
        first[i] = -1;
    for (int32 k = 0; k < SIDE; k++) {
        int32 index = from + ((k - from) & (SIDE - 1));
        int32 c = (int16)(index * 32 + axis->low * 8);
        struct tx_place place;

        tx_place_row(axis, tx_relative(axis, c) >> 5, &place);
        shown->coordinate[k] = (int16)c;
        if (first[place.index & 1023] < 0)
            first[place.index & 1023] = (int16)k;
        shown->same[k] = (uint8)first[place.index & 1023];
    }
}

static uint32 colour_at(const struct tx *tx, int32 tile, int32 s, int32 t,
                        const struct tx_colour *shade)
{
    struct tx_sources sources;

    tx_sample(tx, tile, s, t, 0, 0, &sources.texel0);
    sources.texel1 = sources.texel0;
    sources.shade = *shade;
    sources.fraction = 0;
    return tx_combine_pixel(tx, &sources);
}

static void make_row(uint8 *row, const struct tx *tx, int32 tile, const struct shown *columns,
                     int32 t, int32 pixel_bytes, const struct tx_colour *shade)
{
    for (int32 u = 0; u < SIDE; u++) {
        int32 same = columns->same[u];
        uint32 colour = same < u ? tx_pixel_read(row, same, pixel_bytes)
                      : tx_pixel_of(colour_at(tx, tile, columns->coordinate[u], t, shade),
                                    pixel_bytes);

        tx_pixel_write(row, u, pixel_bytes, colour);
    }
}

static void copy_row(uint8 *to, const uint8 *from, int32 bytes)
{
    for (; bytes > 0; bytes -= 4, to += 4, from += 4)
        *(uint32 *)to = *(const uint32 *)from;
}

/* page: row 0; rows 128 to 255 lie before it, as in MAP_PAGE. */
static void make_page(uint8 *page, const struct tx *tx, int32 tile, int32 pixel_bytes,
                      const struct tx_colour *shade)
{
    static struct shown columns, rows;
    int32 pitch = SIDE * pixel_bytes;

    find_shown(&columns, &tx->tiles[tile].s);
    find_shown(&rows, &tx->tiles[tile].t);
    for (int32 v = 0; v < SIDE; v++) {
        int32 same = rows.same[v];
        uint8 *row = page + (int8)v * pitch;

        if (same < v)
            copy_row(row, page + (int8)same * pitch, pitch);
        else
            make_row(row, tx, tile, &columns, rows.coordinate[v], pixel_bytes, shade);
    }
}

/* A tile's axis without where it begins: moving it moves the polygon, not the page. */
static uint32 axis_key(const struct tx_axis *axis)
{
    return (uint32)axis->clamp << 31 | (uint32)axis->mirror << 30 | (uint32)axis->mask << 26
        | (clamps(axis) ? (uint32)axis->low << 12 | axis->high : 0);
}

static uint32 packed(const uint8 *colour)
{
    return (uint32)colour[0] << 24 | (uint32)colour[1] << 16 | (uint32)colour[2] << 8 | colour[3];
}

/* Everything that the page depends on. */
static void find_key(uint32 *key, const struct tx *tx, int32 n, int32 pixel_bytes,
                     const struct tx_colour *shade)
{
    const struct tx_tile *tile = &tx->tiles[n];

    key[0] = tx->tmem_generation;
    key[1] = tx->mode_generation;
    key[2] = (uint32)tile->format << 28 | (uint32)tile->size << 26 | (uint32)tile->palette << 18
        | (uint32)tile->line << 9 | tile->tmem;
    key[3] = axis_key(&tile->s);
    key[4] = axis_key(&tile->t);
    key[5] = packed(tx->primitive);
    key[6] = packed(tx->environment);
    key[7] = (uint32)tx->primitive_fraction << 8 | (uint32)pixel_bytes;
    key[8] = (uint32)shade->r << 16 | (uint32)shade->g;
    key[9] = (uint32)shade->b << 16 | (uint32)shade->a;
}

static int32 page_room(struct tx_unit *unit, int32 bytes)
{
    struct tx_page *page = &unit->page;

    if (page->bytes >= bytes)
        return 1;
    page->bytes = mem_alloc(&page->texels, bytes, unit->memory) ? bytes : 0;
    return page->bytes > 0;
}

int32 tx_page_make(struct tx_unit *unit, int32 tile, int32 pixel_bytes,
                   const struct tx_colour *shade)
{
    struct tx_page *page = &unit->page;
    uint32 key[TX_PAGE_KEY], differs = 0;
    uint8 *origin;

    find_key(key, &unit->tx, tile, pixel_bytes, shade);
    for (int32 i = 0; i < TX_PAGE_KEY; i++) {
        differs |= key[i] ^ page->key[i];
        page->key[i] = key[i];
    }
    if (!differs)
        return 1;
    page->key[0] = ~key[0];     /* of no use until it is made */
    if (!page_room(unit, SIDE * SIDE * pixel_bytes))
        return 0;
    origin = page->texels + SIDE / 2 * SIDE * pixel_bytes;
    make_page(origin, &unit->tx, tile, pixel_bytes, shade);
    page->map.texels = origin;
    page->map.width = page->map.height = SIDE;
    page->map.scale = 65536;
    page->map.layout = MAP_PAGE;
    page->map.texel_bytes = (uint8)pixel_bytes;
    page->map.full = page->map.dark = 0;
    page->key[0] = key[0];
    return 1;
}
