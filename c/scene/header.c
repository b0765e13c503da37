/* Checks the header of a scene file, so that its tables can be read. */
#include "scene/load.h"

#include "system/file.h"

/* The header's tables, in its order: bytes of an entry; the fields to name if it is wrong. */
static const struct {
    uint32 size;
    const char *wrong;
} tables[] = {
#define TABLE(name, type) {sizeof(struct type), #name " or " #name "_at"},
#define BLOCK(name) {1, #name " or " #name "_at"},
    TABLE_LIST(TABLE, BLOCK)
#undef TABLE
#undef BLOCK
};

/* Returns 1 if a table is after the header, inside the file and not too long. A block of bytes has
   a multiple of 8 instead of a limit. */
static int32 table_usable(uint32 at, uint32 count, uint32 size, uint32 bytes)
{
    return at >= sizeof(struct scene_header)
        && (size == 1 ? !(count & 7) : count <= SCENE_COUNT_MAX)
        && table_inside(at, count, size, bytes);
}

uint32 scene_pixel_max(const struct scene_header *h)
{
    return ~(uint32)0 >> (32 - 8 * scene_pixel_bytes(h->format));
}

const char *scene_wrong_start(const struct scene_header *h, uint32 bytes)
{
    if (bytes < sizeof *h)
        return "size";
    if (h->magic != SCENE_MAGIC)
        return "magic";
    if (h->version != SCENE_VERSION)
        return "version";
    return h->size == bytes ? 0 : "size";
}

const char *scene_wrong_header(const struct scene_header *h)
{
    const uint32 *count = &h->textures, *at = &h->textures_at;

    if (h->width < 4 || h->width > FRAME_SIDE_MAX || h->width & 3)
        return "width";
    if (h->height < 1 || h->height > FRAME_SIDE_MAX)
        return "height";
    if (h->pixel_width < 1 || h->pixel_width > 2)
        return "pixel_width";
    if (h->pixel_height < 1 || h->pixel_height > 2)
        return "pixel_height";
    if (h->frames < 1 || h->frames > SCENE_FRAMES_MAX)
        return "frames";
    if (h->format >= PIXEL_FORMATS)
        return "format";
    if (h->background > scene_pixel_max(h))
        return "background";
    if (h->cleared > 1)
        return "cleared";
    if (h->once > 1)
        return "once";
    if (!table_usable(h->palette_at, 256, 4, h->size))
        return "palette_at";
    for (uint32 i = 0; i < sizeof tables / sizeof *tables; i++, count++, at++)
        if (!table_usable(*at, *count, tables[i].size, h->size))
            return tables[i].wrong;
    return 0;
}

uint32 scene_tables_end(const struct scene_header *h)
{
    const uint32 *count = &h->textures, *at = &h->textures_at;
    uint32 most = h->palette_at + 256 * 4;

    for (uint32 i = 0; i < sizeof tables / sizeof *tables; i++, count++, at++)
        if (*at + *count * tables[i].size > most)
            most = *at + *count * tables[i].size;
    return most;
}
