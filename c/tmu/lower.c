/* The least that gives a polygon the same picture. */
#include "polygon/counts.h"
#include "polygon/lower.h"
#include "polygon/page.h"
#include "system/system.h"
#include "tmu/plan.h"

enum { SIDE = MAP_PAGE_SIDE };

static void find_window(uint32 texels, uint32 level, struct page_window *window)
{
    window->origin = 0;
    window->least = 0;
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

/* A texel of the level as a pixel of the frame. */
static uint32 pixel_at(const struct tmu *tmu, const struct tmu_lod *lod,
                       const struct tmu_level *level, uint32 i, uint32 j, int32 pixel_bytes)
{
    uint32 colour = tmu_combine_pixel(tmu, lod, tmu_texel(tmu, level, i, j), 0);

    return tmu_frame_pixel(colour, pixel_bytes);
}

/* A texel of the level is 2^level pixels wide; both axes repeat within the page. */
static void make_row(uint8 *row, int32 pixel_bytes, const struct tmu *tmu,
                     const struct tmu_lod *lod, const struct tmu_level *level, uint32 j)
{
    const uint32 wide = 1u << lod->level;

    for (uint32 u = 0; u < SIDE; u++) {
        const uint32 same = u & ~(wide - 1) & ((level->columns << lod->level) - 1);
        uint16 *row_16 = (uint16 *)row;
        uint32 *row_32 = (uint32 *)row;
        uint32 pixel;

        if (same < u)
            pixel = pixel_bytes == 2 ? row_16[same] : row_32[same];
        else
            pixel = pixel_at(tmu, lod, level, u >> lod->level, j, pixel_bytes);
        if (pixel_bytes == 2)
            row_16[u] = (uint16)pixel;
        else
            row_32[u] = pixel;
    }
}

/* Rows 128 to 255 lie before row 0. */
static void make_page(struct tmu_page *page, const struct tmu *tmu, const struct tmu_lod *lod,
                      const struct tmu_level *level)
{
    const int32 bytes = page->map.texel_bytes, pitch = SIDE * bytes;
    uint8 *origin = page->texels + SIDE / 2 * pitch;

    for (int32 v = 0; v < SIDE; v++) {
        const int32 j = v >> lod->level & (int32)(level->rows - 1), same = j << lod->level;
        uint32 *row = (uint32 *)(origin + (int8)v * pitch);

        if (same < v) {
            const uint32 *from = (const uint32 *)(origin + (int8)same * pitch);

            for (int32 k = 0; k < pitch / 4; k++)
                row[k] = from[k];
        } else {
            make_row((uint8 *)row, bytes, tmu, lod, level, (uint32)j);
        }
    }
}

static int32 page_room(struct tmu_page *page, int32 pixel_bytes, int32 memory)
{
    const int32 bytes = SIDE * SIDE * pixel_bytes;

    if (page->bytes < bytes)
        page->bytes = mem_alloc(&page->texels, bytes, memory) ? bytes : 0;
    page_map(&page->map, pixel_bytes);
    page->map.texels = page->texels + bytes / 2;
    return page->bytes > 0;
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
    if (!page_room(page, pixel_bytes, pipe->memory))
        return 0;
    make_page(page, tmu, lod, level);
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
    page_material(plain, s->material, &pipe->page.map);
    *vertices = page_vertices(s, page_origin(s, &s->given->s, &columns),
                              page_origin(s, &s->given->t, &rows));
    return 1;
}
