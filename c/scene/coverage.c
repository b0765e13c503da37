/* Memory for what of a scene's frame is drawn already. */
#include "polygon/kind.h"
#include "scene/load.h"
#include "system/system.h"

static int32 make_lines(struct cut_lines *lines, int32 count)
{
    return mem_alloc(&lines->lines, count * (int32)sizeof *lines->lines, MEMORY_ANY)
        && mem_alloc(&lines->steps, count * (int32)sizeof *lines->steps, MEMORY_ANY)
        && mem_alloc(&lines->rows, (2 * count + 3) & ~3, MEMORY_ANY);
}

const char *scene_wrong_once(const struct scene *scene)
{
    const struct scene_instance *o = scene->instances;

    for (uint32 i = scene->header->once ? scene->header->instances : 0; i; i--, o++) {
        const struct scene_material *m = &scene->materials[o->material];

        if (o->tree != TREE_Z
            && (m->edges != EDGES_EXACT || m->mapper == MAPPER_KEYED || mappers[m->mapper].is & MAPPER_UNIT))
            return "once";
    }
    return 0;
}

int32 scene_make_coverage(struct scene *scene)
{
    const struct scene_header *header = scene->header;
    const int32 height = header->height, room = height * (1 + COVERAGE_GAPS);
    struct coverage *c;

    scene->is_once = 0;
    if (!header->once)
        return 1;
    if (!mem_alloc(&scene->coverage, sizeof *scene->coverage, MEMORY_ANY))
        return 0;
    scene->is_once = 1;
    c = scene->coverage;
    c->room = room;
    return mem_alloc(&c->rows, height * (int32)sizeof *c->rows, MEMORY_ANY)
        && mem_alloc(&c->gaps, room * (int32)sizeof *c->gaps, MEMORY_ANY)
        && mem_alloc(&c->parts, (room + height) * (int32)sizeof *c->parts, MEMORY_ANY)
        && make_lines(&c->second, height)
        && make_lines(&c->further, room)
        && mem_alloc(&c->aside_pixels, header->width * height * scene_pixel_bytes(header->format), MEMORY_ANY);
}
