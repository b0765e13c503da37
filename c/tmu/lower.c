/* The least that gives a polygon the same picture. */
#include "polygon/counts.h"
#include "polygon/lower.h"
#include "tmu/plan.h"

enum { SIDE = MAP_PAGE_SIDE };

static void find_window(uint32 texels, uint32 level, struct page_window *window)
{
    window->origin = 0;
    window->period = (fix16)(texels << level << 16);
}

/* Whether no texel is clamped. */
static int32 is_inside(const struct setup *s, const fix16 *value, const struct page_window *window)
{
    const fix16 high = window->period - PAGE_MARGIN * 65536;

    for (int32 i = 0; i < s->count; i++) {
        if (*value < PAGE_MARGIN * 65536 || *value >= high)
            return 0;
        value += sizeof(struct vertex) / sizeof *value;
    }
    return 1;
}

/* A texel of the level is 2^level pixels wide; both axes repeat within the page. */
static void make_row_16(uint16 *row, const struct tmu *tmu, const struct tmu_lod *lod,
                        const struct tmu_level *level, uint32 v)
{
    const uint32 wide = 1u << lod->level;

    for (uint32 u = 0; u < SIDE; u += wide) {
        const uint32 i = u >> lod->level;
        uint16 pixel = i < level->columns
            ? (uint16)tmu_frame_pixel(tmu_combine_pixel(tmu, lod, tmu_texel(tmu, level, i, v), 0), 2)
            : row[u - (level->columns << lod->level)];

        for (uint32 k = u; k < u + wide; k++)
            row[k] = pixel;
    }
}

static void make_row_32(uint32 *row, const struct tmu *tmu, const struct tmu_lod *lod,
                        const struct tmu_level *level, uint32 v)
{
    const uint32 wide = 1u << lod->level;

    for (uint32 u = 0; u < SIDE; u += wide) {
        const uint32 i = u >> lod->level;
        uint32 pixel = i < level->columns
            ? tmu_frame_pixel(tmu_combine_pixel(tmu, lod, tmu_texel(tmu, level, i, v), 0), 4)
            : row[u - (level->columns << lod->level)];

        for (uint32 k = u; k < u + wide; k++)
            row[k] = pixel;
    }
}

static void make_page(const struct page *page, const struct tmu *tmu, const struct tmu_lod *lod,
                      const struct tmu_level *level)
{
    const int32 bytes = page->map.texel_bytes, pitch = SIDE * bytes;
    uint8 *origin = (uint8 *)page->map.texels;

    for (int32 v = 0; v < SIDE; v++) {
        const int32 j = v >> lod->level & (int32)(level->rows - 1), same = j << lod->level;
        uint32 *row = (uint32 *)(origin + (int8)v * pitch);

        if (same < v) {
            const uint32 *from = (const uint32 *)(origin + (int8)same * pitch);

            for (int32 k = 0; k < pitch / 4; k++)
                row[k] = from[k];
        } else if (bytes == 2) {
            make_row_16((uint16 *)row, tmu, lod, level, (uint32)j);
        } else {
            make_row_32(row, tmu, lod, level, (uint32)j);
        }
    }
}

static int32 find_page(struct tmu_pipe *pipe, const struct tmu_lod *lod,
                       const struct tmu_level *level, int32 pixel_bytes)
{
    const struct tmu *tmu = pipe->chain.units[0];
    struct tmu_page *page = &pipe->page;
    uint32 key[TMU_PAGE_KEY], differs = 0;

    key[0] = (uint32)pixel_bytes;
    key[1] = tmu->mode_generation;
    key[2] = tmu->memory_generation;
    key[3] = tmu->table_generation;
    for (int32 i = 0; i < TMU_PAGE_KEY; i++) {
        differs |= key[i] ^ page->key[i];
        page->key[i] = key[i];
    }
    if (!differs)
        return 1;
    page->key[0] = 0;           /* of no use until it is made */
    if (!page_ready(&page->page, pixel_bytes, pipe->memory))
        return 0;
    make_page(&page->page, tmu, lod, level);
    page->key[0] = key[0];
    return 1;
}

/* One unit's points of one level, not divided. */
static int32 is_plain(const struct setup *s, const struct tmu_pipe *pipe, struct tmu_lod *lod,
                      struct tmu_level *level, struct page_window *columns,
                      struct page_window *rows)
{
    const struct tmu *tmu = pipe->chain.units[0];

    if (pipe->chain.count > 1 || !tmu_only_lod(tmu, lod) || lod->filter != TMU_POINT)
        return 0;
    tmu_find_level(&tmu->modes, lod->level, level);
    find_window(level->columns, lod->level, columns);
    find_window(level->rows, lod->level, rows);
    return (!tmu->modes.clamp_s || is_inside(s, &s->given->s, columns))
        && (!tmu->modes.clamp_t || is_inside(s, &s->given->t, rows));
}

int32 tmu_lower_to_plain(struct setup *s, struct tmu_pipe *pipe, struct material *plain,
                         const struct vertex **vertices)
{
    const int32 divided = pipe->chain.units[0]->modes.perspective;
    struct page_window columns, rows;
    struct tmu_level level;
    struct tmu_lod lod;

    if ((divided && !(s->given->w > 0 && APPLIES(CONSTANT_W, lower_w_is_constant(s))))
        || !APPLIES(TMU_PLAIN, is_plain(s, pipe, &lod, &level, &columns, &rows)
                    && find_page(pipe, &lod, &level, s->frame->pixel_bytes)))
        return 0;
    page_material(plain, s->material, &pipe->page.page);
    *vertices = page_vertices(s, &columns, &rows);
    return 1;
}
