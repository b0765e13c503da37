/* Glide's texture units of a scene. */
#include "scene/scene.h"

#include "system/file.h"
#include "system/system.h"

/* A table in the texture memory, or none. */
static int32 table_fits(const struct scene_header *h, int32 at, uint32 bytes)
{
    return at == NO_TABLE
        || (at >= 0 && !(at & 3) && table_inside((uint32)at, bytes, 1, h->tmu_memory));
}

static enum tmu_result set_up(struct tmu *tmu, const struct scene_tmu *from, uint8 *memory)
{
    enum tmu_result result = tmu_init(tmu, memory, from->bytes);

    if (result == TMU_DONE)
        result = tmu_fraction_bits(tmu, from->fraction_bits);
    if (result == TMU_DONE)
        result = tmu_bilinear_by(tmu, from->dithered);
    if (result == TMU_DONE)
        result = tmu_subdivision(tmu, from->subdivision);
    if (result == TMU_DONE)
        result = tmu_registers(tmu, from->mode, from->lod, from->detail, from->base);
    return result;
}

static const char *wrong_tmu(const struct scene *scene, const struct scene_tmu *from)
{
    const struct scene_header *h = scene->header;
    static struct tmu tmu;

    if (from->memory & 3 || !table_inside(from->memory, from->bytes, 1, h->tmu_memory))
        return "tmu.memory";
    if (!table_fits(h, from->palette, TMU_ENTRIES * 4))
        return "tmu.palette";
    if (!table_fits(h, from->ncc, TMU_NCC_TABLES * TMU_NCC_REGISTERS * 4))
        return "tmu.ncc";
    switch (set_up(&tmu, from, 0)) {
    case TMU_DONE:
        return 0;
    case TMU_BAD_MEMORY:
        return "tmu.bytes";
    case TMU_BAD_FRACTION_BITS:
        return "tmu.fraction_bits";
    case TMU_BAD_SUBDIVISION:
        return "tmu.subdivision";
    case TMU_BAD_FLAG:
        return "tmu.dithered";
    default:
        return "tmu.mode, lod, detail or base";
    }
}

const char *scene_wrong_pipe(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_tmu *tmu = scene->tmus;
    const struct scene_pipe *pipe = scene->pipes;

    for (uint32 i = 0; i < h->tmus; i++, tmu++) {
        const char *wrong = wrong_tmu(scene, tmu);

        if (wrong)
            return wrong;
    }
    for (uint32 i = 0; i < h->pipes; i++, pipe++) {
        if (pipe->tmus < 1 || pipe->tmus > TMU_UNITS || pipe->tmu > h->tmus
            || pipe->tmus > h->tmus - pipe->tmu)
            return "pipe.tmus";
        if (pipe->own != 0 && (pipe->own != 2 || pipe->tmus < 2))
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

static void load_tables(struct tmu *tmu, const struct scene_tmu *from, const uint8 *memory)
{
    const uint32 *registers = (const uint32 *)(memory + from->ncc);

    if (from->palette != NO_TABLE)
        tmu_palette(tmu, 0, TMU_ENTRIES - 1, (const uint32 *)(memory + from->palette));
    if (from->ncc == NO_TABLE)
        return;
    for (uint32 table = 0; table < TMU_NCC_TABLES; table++)
        tmu_ncc_registers(tmu, table, registers + TMU_NCC_REGISTERS * table);
}

int32 scene_make_pipes(struct scene *scene, int32 kind)
{
    const struct scene_header *h = scene->header;
    uint8 *memory = (uint8 *)h + h->tmu_memory_at;

    if (!h->pipes)
        return 1;
    if (!mem_alloc(&scene->tmu, (int32)(h->tmus * sizeof *scene->tmu), MEMORY_ANY)
        || !mem_alloc(&scene->pipe, (int32)(h->pipes * sizeof *scene->pipe), MEMORY_ANY))
        return 0;
    for (uint32 i = 0; i < h->tmus; i++) {
        const struct scene_tmu *from = &scene->tmus[i];

        set_up(&scene->tmu[i], from, memory + from->memory);
        load_tables(&scene->tmu[i], from, memory);
    }
    for (uint32 i = 0; i < h->pipes; i++) {
        const struct scene_pipe *from = &scene->pipes[i];
        struct tmu *units[TMU_UNITS];

        for (uint32 n = 0; n < from->tmus; n++)
            units[n] = &scene->tmu[from->tmu + n];
        tmu_pipe_init(&scene->pipe[i], units, from->tmus, kind);
        tmu_chain_hints(&scene->pipe[i].chain, from->own);
        tmu_pipe_prefilter(&scene->pipe[i], from->prefilter);
        tmu_pipe_adds(&scene->pipe[i], from->adds);
    }
    return 1;
}

/* The second half of the vertices is what the second unit goes by. */
static enum polygon_result draw_own(const struct frame *frame, const struct vertex *vertices,
                                    int32 count, const struct material *material,
                                    const struct drawing *drawing)
{
    material->pipe->own = vertices + (count >> 1);
    return tmu_polygon_draw(frame, vertices, count >> 1, material, drawing);
}

polygon_routine *scene_pipe_routine(const struct scene *scene,
                                    const struct scene_material *material)
{
    return scene_has_own(scene, material) ? draw_own : tmu_polygon_draw;
}

void scene_settle_pipes(const struct scene *scene, int32 settled)
{
    for (uint32 i = 0; i < scene->header->pipes; i++)
        scene->pipe[i].settled = settled;
}

const char *scene_why_pipe_refused(const struct scene *scene)
{
    for (uint32 i = 0; i < scene->header->pipes; i++)
        if (scene->pipe[i].result != TMU_DONE)
            return tmu_result_text(scene->pipe[i].result);
    return 0;
}
