#include "scene/tables.h"

#include "span/far.h"
#include "span/logarithm.h"
#include "system/system.h"
#include "triangle/triangles.h"

/* Tables that a scene may need. */
enum { RECIPROCALS = 1, LOGARITHMS = 2, SNAPPED = 4 };

/* Polygons in perspective of wider texels are drawn without tables. */
static uint32 tables_needed(const struct scene *scene)
{
    const struct material *material = scene->drawn;
    uint32 needed = 0;

    for (uint32 i = scene->header->materials; i > 0; i--, material++) {
        if (material->edges == EDGES_SNAPPED)
            needed |= SNAPPED;
        if (!material->perspective || material->map->texel_bytes > 1)
            continue;
        if (material->perspective == PERSPECTIVE_PIXEL)
            needed |= LOGARITHMS;
        if (material->perspective == PERSPECTIVE_EVERY16
            || material->perspective == PERSPECTIVE_EVERY8 || material->tolerance)
            needed |= RECIPROCALS;
    }
    return needed;
}

static void make_triangles(struct scene *scene)
{
    struct triangle_tables *tables;

    scene->tried_triangles = 1;
    if (!mem_alloc(&tables, sizeof *tables, MEMORY_ANY))
        return;
    triangle_tables_make(tables);
    scene->triangles = tables;
}

static void make_reciprocals(struct scene *scene)
{
    uint16 *table;

    scene->tried_reciprocals = 1;
    if (mem_alloc(&table, FAR_COUNT * sizeof *table, MEMORY_ANY))
        scene->reciprocals = reciprocals_make(table);
}

static void make_logarithms(struct scene *scene)
{
    struct logarithm_tables *tables;
    int16 *logs;
    uint16 *powers;

    scene->tried_logarithms = 1;
    if (!mem_alloc(&powers, LOGARITHM_POWERS * sizeof *powers, MEMORY_ANY)
        || !mem_alloc(&logs, LOGARITHM_COUNT * sizeof *logs, MEMORY_ANY)
        || !mem_alloc(&tables, sizeof *tables, MEMORY_ANY))
        return;
    logarithms_make(tables, logs, powers);
    scene->logarithms = tables;
}

enum scene_memory scene_make_tables(struct scene *scene)
{
    const uint32 needed = tables_needed(scene);

    if (needed & RECIPROCALS && !scene->tried_reciprocals)
        make_reciprocals(scene);
    if (needed & SNAPPED && !scene->tried_triangles)
        make_triangles(scene);
    if (needed & LOGARITHMS && !scene->tried_logarithms)
        make_logarithms(scene);
    return (needed & RECIPROCALS && !scene->reciprocals) || (needed & SNAPPED && !scene->triangles)
         ? SCENE_RECIPROCALS
         : needed & LOGARITHMS && !scene->logarithms ? SCENE_LOGARITHMS : SCENE_MADE;
}
