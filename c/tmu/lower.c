/* The least that gives a polygon the same picture. */
#include "polygon/counts.h"
#include "polygon/lower.h"
#include "tmu/plan.h"

enum { SIDE = MAP_PAGE_SIDE };

static void find_window(uint32 texels, uint32 level, struct page_window *window)
{
    window->origin = 0;
    window->least = PAGE_LEAST_ROW;     /* of columns too: they repeat */
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

/* What a page's rows are made with. */
struct making {
    const struct page *page;
    const struct tmu *tmu;
    const struct tmu_lod *lod;
    const struct tmu_level *level;
};

/* Which row shows the same and is made, or end. */
static int32 find_same(const struct making *m, int32 v, int32 from, int32 end)
{
    const int32 period = (int32)m->level->rows << m->lod->level;
    const int32 beside = v < from ? v + 1 : v - 1, far = v < from ? v + period : v - period;

    if (from == end)
        return end;
    return beside >> m->lod->level == v >> m->lod->level ? beside
        : far >= from && far < end ? far : end;
}

static void make_row(void *context, int32 v, int32 from, int32 end)
{
    const struct making *m = context;
    const int32 bytes = m->page->map.texel_bytes, same = find_same(m, v, from, end);
    const uint32 j = (uint32)v >> m->lod->level & (m->level->rows - 1);
    uint32 *row = (uint32 *)page_row(m->page, v);

    if (same != end) {
        const uint32 *other = (const uint32 *)page_row(m->page, same);

        for (int32 k = 0; k < SIDE * bytes / 4; k++)
            row[k] = other[k];
    } else if (bytes == 2) {
        make_row_16((uint16 *)row, m->tmu, m->lod, m->level, j);
    } else {
        make_row_32(row, m->tmu, m->lod, m->level, j);
    }
}

static int32 find_page(struct tmu_pipe *pipe, const struct tmu_lod *lod,
                       const struct tmu_level *level, int32 pixel_bytes,
                       const struct page_rows *rows)
{
    const struct tmu *tmu = pipe->chain.units[0];
    struct tmu_page *page = &pipe->page;
    uint32 key[TMU_PAGE_KEY];
    struct making making;

    key[0] = (uint32)pixel_bytes;
    key[1] = tmu->mode_generation;
    key[2] = tmu->memory_generation;
    key[3] = tmu->table_generation;
    if (page_differs(page->key, key, TMU_PAGE_KEY))
        page_forget(&page->page);
    if (page_has(&page->page, rows))
        return 1;
    if (!page_ready(&page->page, pixel_bytes, pipe->memory, rows))
        return 0;
    making.page = &page->page;
    making.tmu = tmu;
    making.lod = lod;
    making.level = level;
    page_grow(&page->page, rows, make_row, &making);
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
    struct page_rows shown;
    struct tmu_level level;
    struct tmu_lod lod;

    if ((divided && !(s->given->w > 0 && APPLIES(CONSTANT_W, lower_w_is_constant(s))))
        || !APPLIES(TMU_PLAIN, is_plain(s, pipe, &lod, &level, &columns, &rows)))
        return 0;
    *vertices = page_vertices(s, &columns, &rows, &shown);
    if (!find_page(pipe, &lod, &level, s->frame->pixel_bytes, &shown))
        return 0;
    page_material(plain, s->material, &pipe->page.page);
    return 1;
}
