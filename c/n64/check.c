/* Checks whether a state can be drawn with, and notes the syncs due after drawing. */
#include "n64/n64.h"

void n64_init(struct n64 *n64, const uint8 *dram, uint32 dram_bytes)
{
    const struct n64_input texel = {15, 15, 31, 1}, alpha = {7, 7, 7, 1};
    uint8 *bytes = (uint8 *)n64;

    for (uint32 i = 0; i < sizeof *n64; i++)
        bytes[i] = 0;
    n64->dram = dram;
    n64->dram_bytes = dram_bytes;
    n64->checked = 1;
    for (int32 cycle = 0; cycle < 2; cycle++) {
        n64->combine.rgb[cycle] = texel;
        n64->combine.alpha[cycle] = alpha;
    }
    n64_command(n64, (uint32)N64_OP_OTHER_MODES << 24 | 1u << 11 | 1u << 10, 0);
}

static int32 drawable_pair(uint32 format, uint32 size)
{
    static const uint8 sizes[] = {      /* of RGBA, YUV, CI, IA, I */
        1 << N64_16 | 1 << N64_32, 1 << N64_16, 1 << N64_4 | 1 << N64_8,
        1 << N64_4 | 1 << N64_8 | 1 << N64_16, 1 << N64_4 | 1 << N64_8
    };

    return format <= N64_I && sizes[format] >> size & 1;
}

int32 n64_loadable_pair(uint32 format, uint32 size)
{
    return size != N64_4 && (drawable_pair(format, size) || (size == N64_16 && format <= N64_I));
}

int32 n64_is_split(const struct n64_tile *tile)
{
    return tile->format == N64_YUV || (tile->format == N64_RGBA && tile->size == N64_32);
}

static int32 clamps(const struct n64_axis *axis)
{
    return axis->clamp || !axis->mask;
}

/* Returns how many columns or rows an axis can show. */
static uint32 shown(const struct n64_axis *axis)
{
    const uint32 inside = ((uint32)axis->high >> 2) - ((uint32)axis->low >> 2) + 1;
    const uint32 masked = 1u << (axis->mask < 10 ? axis->mask : 10);

    if (!axis->mask)
        return inside;
    return clamps(axis) && inside < masked ? inside : masked;
}

/* Returns the TMEM words of a row of texels; of split ones, those in the low half. */
static uint32 row_words(const struct n64_tile *tile, uint32 texels)
{
    if (tile->size == N64_4)
        return (texels + 15) >> 4;
    if (tile->size == N64_8 || tile->format == N64_YUV)
        return (texels + 7) >> 3;
    return (texels + 3) >> 2;
}

/* Checks that all texels which the tile can show are where its format allows. */
static enum n64_result check_place(const struct n64_tile *tile, int32 low_only)
{
    const uint32 columns = shown(&tile->s), rows = shown(&tile->t);
    const uint32 end = tile->tmem + (rows - 1) * tile->line + row_words(tile, columns);

    if (columns > N64_COLUMNS_MAX || rows > N64_ROWS_MAX)
        return N64_TILE_TOO_LARGE;
    if (n64_is_split(tile)) {
        if (tile->tmem >= N64_HALF_WORDS)
            return N64_SPLIT_HIGH;
        return end > N64_HALF_WORDS ? N64_TILE_OUTSIDE : N64_DONE;
    }
    if (low_only && end > N64_HALF_WORDS)
        return N64_INDEX_HIGH;
    return end > N64_TMEM_WORDS ? N64_TILE_OUTSIDE : N64_DONE;
}

enum n64_result n64_check_tile(const struct n64 *n64, int32 n)
{
    const struct n64_tile *tile = &n64->tiles[n & 7];
    const int32 index = tile->format == N64_CI;

    if (!n64->checked)
        return N64_DONE;
    if (!drawable_pair(tile->format, tile->size))
        return N64_ILLEGAL_PAIR;
    if (index != n64->modes.tlut)
        return N64_TLUT_MODE;
    if (n64->modes.cycle == N64_COPY && !index && (tile->size != N64_16 || tile->format == N64_YUV))
        return N64_CYCLE_TYPE;
    if ((clamps(&tile->s) && tile->s.high >> 2 < tile->s.low >> 2)
        || (clamps(&tile->t) && tile->t.high >> 2 < tile->t.low >> 2))
        return N64_TILE_EDGES;
    return check_place(tile, index);
}

uint32 n64_tiles_used(const struct n64 *n64)
{
    uint32 count = 1, used = 0;

    if (n64->modes.cycle == N64_FILL)
        return 0;
    if (n64->modes.cycle != N64_COPY && n64->modes.lod)
        count = n64->max_level + 1u + n64->modes.detail;
    else if (n64->inputs & N64_INPUT_TEXEL1)
        count = 2;
    while (count--)
        used |= 1u << ((n64->primitive_tile + count) & 7);
    return used;
}

enum n64_result n64_check_drawing(const struct n64 *n64)
{
    const uint32 used = n64_tiles_used(n64);
    enum n64_result result = N64_DONE;

    if (!n64->checked)
        return N64_DONE;
    if (n64->modes.cycle == N64_FILL)
        return N64_CYCLE_TYPE;
    for (int32 n = 0; n < N64_TILES && result == N64_DONE; n++)
        if (used >> n & 1)
            result = n64_check_tile(n64, n);
    return result == N64_DONE ? n64_check_combine(&n64->combine) : result;
}

static int32 in_range(fix16 texels)
{
    return texels >= -(1024 * 65536) && texels < 1024 * 65536;
}

enum n64_result n64_check_coordinates(const struct n64 *n64, fix16 s, fix16 t)
{
    return n64->checked && !(in_range(s) && in_range(t)) ? N64_COORDINATE_RANGE : N64_DONE;
}

void n64_drawn_from(struct n64 *n64, uint32 used)
{
    n64->pending = N64_PENDING_LOAD | N64_PENDING_TILE | N64_PENDING_PIPE;
    n64->pending_tiles |= (uint8)used;
}

void n64_drawn(struct n64 *n64)
{
    n64_drawn_from(n64, n64_tiles_used(n64));
}
