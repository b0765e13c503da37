#include "n64/polygons/decode.h"

#include "drawing/page.h"
#include "polygon/key.h"

/* The tile that is decoded. */
struct making {
    struct n64_decode_scratch *scratch;
    struct n64_rows rows;
    const struct n64_axis *t;
    int32 width, height;
    enum n64_quads quads;
    int32 reach;                /* columns to the neighbour in quads */
    int32 texels;               /* of a row, up to the last that columns show */
    int32 in_order;             /* column k shows texel k */
    uint32 *to;
};

/* Returns log2 of the number of columns or rows that relative coordinates can distinguish. */
static uint32 bits_of(const struct n64_axis *axis)
{
    const uint32 mask = axis->mask < 10 ? axis->mask : 10;
    const uint32 period = mask + (axis->mirror ? 1 : 0);
    const uint32 last = (uint32)((axis->high >> 2) - (axis->low >> 2)) & 0x3ff;
    uint32 bits = 0;

    if (axis->mask && !axis->clamp)
        return period;
    while (last >> bits)
        bits++;
    return axis->mask && period < bits ? period : bits;
}

static void list_columns(struct making *m, const struct n64_axis *axis)
{
    struct n64_column *columns = m->scratch->columns;
    struct n64_place place;

    m->texels = 1;
    m->in_order = 1;
    for (int32 k = 0; k < m->width; k++) {
        n64_place(axis, (uint32)k, N64_COLUMN, &place);
        columns[k].index = (int16)place.index;
        columns[k].next = (int16)(place.index + m->reach * place.step);
        m->in_order &= place.index == k;
        if (place.index >= m->texels)
            m->texels = place.index + 1;
    }
    for (int32 k = 0; k < m->width; k++) {
        const int32 beside = (k + m->reach) & (m->width - 1);

        columns[k].next_at = (int16)(columns[beside].index == columns[k].next ? beside : -1);
    }
}

/* Finds the rows of TMEM that row j and its neighbour show. */
static void place_row(const struct making *m, int32 j, int32 *index, int32 *next)
{
    struct n64_place row;

    n64_place(m->t, (uint32)j, N64_ROW, &row);
    *index = row.index & 255;
    *next = *index + row.step;
}

/* Decodes a row of TMEM in the order of the columns. */
static void decode_columns(const struct making *m, int32 row, uint32 *to)
{
    const struct n64_column *column = m->scratch->columns;

    if (m->in_order && !(m->width & 1)) {
        n64_rows_decode(&m->rows, row, to, m->width);
        return;
    }
    n64_rows_decode(&m->rows, row, m->scratch->line, m->texels);
    for (int32 k = m->width; k > 0; k--, column++)
        *to++ = m->scratch->line[column->index];
}

/* The same; chroma's texels have U for A too. */
static void decode_row(const struct making *m, int32 row, uint32 *to)
{
    decode_columns(m, row, to);
    if (m->quads == N64_QUADS_CHROMA)
        for (int32 k = m->width; k > 0; k--, to++)
            ((uint8 *)to)[3] = ((uint8 *)to)[0];
}

static uint32 decode_one(const struct making *m, int32 s, int32 row)
{
    const uint32 texel = n64_rows_texel(&m->rows, s, row);

    return m->quads == N64_QUADS_CHROMA ? (texel & 0xffffff00) | texel >> 24 : texel;
}

/* Decodes each row of TMEM once; other rows that show it are copies. */
static void decode_texels(const struct making *m)
{
    const uint32 **shown = m->scratch->shown;
    uint32 *to = m->to;
    int32 row, next;

    for (int32 j = 0; j < N64_ROWS_MAX; j++)
        shown[j] = 0;
    for (int32 j = 0; j < m->height; j++, to += m->width) {
        place_row(m, j, &row, &next);
        if (shown[row])
            for (int32 k = 0; k < m->width; k++)
                to[k] = shown[row][k];
        else
            decode_row(m, row, to);
        shown[row] = to;
    }
}

/* Returns the texels of TMEM row next, below row j: from the decoded row if that shows it. */
static const uint32 *row_below(const struct making *m, int32 j, int32 next)
{
    const int32 below = j + 1 < m->height ? j + 1 : 0;
    int32 row, beyond;

    place_row(m, below, &row, &beyond);
    if (row == next)
        return m->to + below * m->width;
    decode_row(m, next, m->scratch->below);
    return m->scratch->below;
}

/* Makes a row's quads. Those whose neighbour in s is `reach` columns on are made at once, the
   others one by one. */
static void decode_quads(const struct making *m, int32 j, struct n64_quad *quads)
{
    const struct n64_column *columns = m->scratch->columns;
    const uint32 *here = m->to + j * m->width, *below;
    struct n64_quad_row by;
    int32 row, next;

    place_row(m, j, &row, &next);
    by.below = below = row_below(m, j, next);
    by.step = m->reach;
    for (int32 k = 0; k < m->reach; k++, by.below++)
        if (m->width > m->reach + k)
            n64_quads(here + k, quads + k, &by, (m->width - 1 - k) / m->reach);
    by.step = 1;
    for (int32 k = 0; k < m->width; k++) {
        const int32 at = columns[k].next_at, beside = columns[k].next;
        uint32 above[2], under[2];

        if (at == k + m->reach)
            continue;
        above[0] = here[k];
        under[0] = below[k];
        above[1] = at < 0 ? decode_one(m, beside, row) : here[at];
        under[1] = at < 0 ? decode_one(m, beside, next) : below[at];
        by.below = under;
        n64_quads(above, quads + k, &by, 1);
    }
}

static uint32 axis_key(const struct n64_axis *axis)
{
    const uint32 clamps = axis->clamp || !axis->mask;

    return clamps << 31 | (uint32)axis->mirror << 30 | (uint32)axis->mask << 26
        | (clamps ? (uint32)axis->low << 12 | axis->high : 0);
}

void n64_tile_key_find(uint32 *key, const struct n64_tile *tile)
{
    key[0] = (uint32)tile->format << 28 | (uint32)tile->size << 26 | (uint32)tile->palette << 18
        | (uint32)tile->line << 9 | tile->tmem;
    key[1] = axis_key(&tile->s);
    key[2] = axis_key(&tile->t);
}

enum n64_result n64_decode(struct n64_decoding *decoding, const struct n64 *n64, int32 n,
                           enum n64_quads quads, struct n64_kept *kept)
{
    const struct n64_tile *tile = &n64->tiles[n & 7];
    const uint32 columns_bits = bits_of(&tile->s), rows_bits = bits_of(&tile->t);
    const uint32 count = 1u << (columns_bits + rows_bits);
    struct n64_decoded *decoded = &kept->decoded;
    uint32 key[N64_KEPT_KEY];
    struct making making;

    decoding->made = 0;
    if (columns_bits + rows_bits > N64_DECODE_BITS)
        return N64_DECODE_TOO_LARGE;
    n64_tile_key_find(key, tile);
    key[N64_TILE_KEY] = n64->tmem_generation;
    key[N64_TILE_KEY + 1] = (uint32)n64->modes.tlut << 1 | n64->modes.tlut_type;
    key[N64_TILE_KEY + 2] = (uint32)n64;
    if (!key_differs(kept->key, key, N64_KEPT_KEY)
        && (quads == N64_QUADS_NONE || kept->kind == quads))
        return N64_DONE;
    kept->key[N64_TILE_KEY + 2] = 0;    /* not valid until it is made */
    if (!page_room(&kept->texels, &kept->texels_room, count, sizeof *kept->texels)
        || (quads != N64_QUADS_NONE
            && !page_room(&kept->quads, &kept->quads_room, count, sizeof *kept->quads)))
        return N64_NO_MEMORY;
    making.scratch = decoding->scratch;
    n64_rows_find(&making.rows, n64, tile, decoding->scratch, decoding->colours);
    making.t = &tile->t;
    making.width = 1 << columns_bits;
    making.height = 1 << rows_bits;
    making.quads = quads;
    making.reach = quads == N64_QUADS_CHROMA ? 2 : 1;
    making.to = kept->texels;
    list_columns(&making, &tile->s);
    decode_texels(&making);
    if (quads != N64_QUADS_NONE)
        for (int32 j = 0; j < making.height; j++)
            decode_quads(&making, j, kept->quads + j * making.width);
    decoded->texels = kept->texels;
    decoded->quads = quads != N64_QUADS_NONE ? kept->quads : 0;
    decoded->columns_bits = (uint16)columns_bits;
    decoded->rows_bits = (uint16)rows_bits;
    decoded->mask_s = (uint16)(((1u << columns_bits) - 1) << 5);
    decoded->mask_t = (uint16)(((1u << rows_bits) - 1) << 5);
    kept->kind = quads;
    kept->key[N64_TILE_KEY + 2] = (uint32)n64;
    decoding->made = 1;
    return N64_DONE;
}
