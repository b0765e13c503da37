/* Glide's texture units of a scene. */
#include "scene/load.h"

#include "glide/polygons/tiles.h"
#include "system/file.h"
#include "system/system.h"

/* Returns 1 if a table is inside the texture memory or is NO_TABLE. */
static int32 table_fits(const struct scene_header *h, int32 at, uint32 bytes)
{
    return at == NO_TABLE
        || (at >= 0 && !(at & 3) && table_inside((uint32)at, bytes, 1, h->glide_memory));
}

static enum glide_result set_up(struct glide *glide, const struct scene_glide_unit *from, uint8 *memory)
{
    enum glide_result result = glide_init(glide, memory, from->bytes);

    if (result == GLIDE_DONE)
        result = glide_fraction_bits(glide, from->fraction_bits);
    if (result == GLIDE_DONE)
        result = glide_bilinear_by(glide, from->dithered);
    if (result == GLIDE_DONE)
        result = glide_subdivision(glide, from->subdivision);
    if (result == GLIDE_DONE)
        result = glide_registers(glide, from->mode, from->lod, from->detail, from->base);
    return result;
}

static const char *wrong_glide_unit(const struct scene *scene, const struct scene_glide_unit *from)
{
    const struct scene_header *h = scene->header;
    static struct glide glide;

    if (from->memory & 3 || !table_inside(from->memory, from->bytes, 1, h->glide_memory))
        return "glide_unit.memory";
    if (!table_fits(h, from->palette, GLIDE_ENTRIES * 4))
        return "glide_unit.palette";
    if (!table_fits(h, from->ncc, GLIDE_NCC_TABLES * GLIDE_NCC_REGISTERS * 4))
        return "glide_unit.ncc";
    switch (set_up(&glide, from, 0)) {
    case GLIDE_DONE:
        return 0;
    case GLIDE_BAD_MEMORY:
        return "glide_unit.bytes";
    case GLIDE_BAD_FRACTION_BITS:
        return "glide_unit.fraction_bits";
    case GLIDE_BAD_SUBDIVISION:
        return "glide_unit.subdivision";
    case GLIDE_BAD_FLAG:
        return "glide_unit.dithered";
    default:
        return "glide_unit.mode, lod, detail or base";
    }
}

const char *scene_wrong_pipe(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_glide_unit *glide = scene->glide_units;
    const struct scene_pipe *pipe = scene->pipes;

    for (uint32 i = 0; i < h->glide_units; i++, glide++) {
        const char *wrong = wrong_glide_unit(scene, glide);

        if (wrong)
            return wrong;
    }
    for (uint32 i = 0; i < h->pipes; i++, pipe++) {
        if (pipe->glide_units < 1 || pipe->glide_units > GLIDE_UNITS || pipe->glide > h->glide_units
            || pipe->glide_units > h->glide_units - pipe->glide)
            return "pipe.glide_units";
        if (pipe->own != 0 && (pipe->own != 2 || pipe->glide_units < 2))
            return "pipe.own";
        if (pipe->adds > 1)
            return "pipe.adds";
    }
    return 0;
}

int32 scene_has_own(const struct scene *scene, const struct scene_material *material)
{
    return material->mapper == MAPPER_GLIDE && scene->pipes[material->unit].own;
}

static void load_tables(struct glide *glide, const struct scene_glide_unit *from, const uint8 *memory)
{
    const uint32 *registers = (const uint32 *)(memory + from->ncc);

    if (from->palette != NO_TABLE)
        glide_palette(glide, 0, GLIDE_ENTRIES - 1, (const uint32 *)(memory + from->palette));
    if (from->ncc == NO_TABLE)
        return;
    for (uint32 table = 0; table < GLIDE_NCC_TABLES; table++)
        glide_ncc_registers(glide, table, registers + GLIDE_NCC_REGISTERS * table);
}

int32 scene_make_pipes(struct scene *scene, int32 kind)
{
    const struct scene_header *h = scene->header;
    uint8 *memory = (uint8 *)h + h->glide_memory_at;

    if (!mem_alloc(&scene->glide, (int32)(h->glide_units * sizeof *scene->glide), MEMORY_ANY)
        || !mem_alloc(&scene->pipe, (int32)(h->pipes * sizeof *scene->pipe), MEMORY_ANY)
        || !mem_alloc(&scene->tiles, sizeof *scene->tiles, MEMORY_ANY))
        return 0;
    glide_tile_store_init(scene->tiles);
    for (uint32 i = 0; i < h->glide_units; i++) {
        const struct scene_glide_unit *from = &scene->glide_units[i];

        set_up(&scene->glide[i], from, memory + from->memory);
        load_tables(&scene->glide[i], from, memory);
    }
    for (uint32 i = 0; i < h->pipes; i++) {
        const struct scene_pipe *from = &scene->pipes[i];
        struct glide *units[GLIDE_UNITS];

        for (uint32 n = 0; n < from->glide_units; n++)
            units[n] = &scene->glide[from->glide + n];
        glide_pipe_init(&scene->pipe[i], units, from->glide_units, kind, scene->tiles);
        glide_chain_hints(&scene->pipe[i].chain, from->own);
        glide_pipe_prefilter(&scene->pipe[i], from->prefilter);
        glide_pipe_adds(&scene->pipe[i], from->adds);
    }
    return 1;
}

/* Draws a polygon whose second half of vertices has the second unit's coordinates. */
static enum polygon_result draw_own(struct renderer *renderer, const struct polygon *polygon,
                                    const struct material *material)
{
    const int32 count = polygon->count >> 1;
    struct polygon half;

    polygon_set(&half, polygon->vertices, count, polygon->planar);
    half.second = polygon->vertices + count;
    return glide_polygon_draw(renderer, &half, material);
}

polygon_routine *scene_pipe_routine(const struct scene *scene,
                                    const struct scene_material *material)
{
    return scene_has_own(scene, material) ? draw_own : glide_polygon_draw;
}

const char *scene_why_pipe_refused(const struct scene *scene)
{
    for (uint32 i = 0; i < scene->header->pipes; i++)
        if (scene->pipe[i].result != GLIDE_DONE)
            return glide_result_text(scene->pipe[i].result);
    return 0;
}
