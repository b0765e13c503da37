#include "scene/tables.h"

#include "span/far.h"
#include "span/logarithm.h"
#include "system/system.h"
#include "triangle/triangles.h"

static int32 needs_reciprocals(const struct material *material)
{
    return material->perspective == PERSPECTIVE_EVERY16
        || material->perspective == PERSPECTIVE_EVERY8 || material->tolerance;
}

static int32 needs_logarithms(const struct material *material)
{
    return material->perspective == PERSPECTIVE_PIXEL;
}

static int32 is_needed(const struct scene *scene, int32 (*needs)(const struct material *))
{
    for (uint32 i = 0; i < scene->header->materials; i++)
        if (needs(&scene->drawn[i]))
            return 1;
    return 0;
}

static int32 needs_snapped(const struct material *material)
{
    return material->edges == EDGES_SNAPPED;
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
    const int32 narrow = scene_pixel_bytes(scene->header->format) == 1;     /* others have no use for them */
    const int32 reciprocals = narrow && is_needed(scene, needs_reciprocals);
    const int32 logarithms = narrow && is_needed(scene, needs_logarithms);
    const int32 snapped = is_needed(scene, needs_snapped);

    if (reciprocals && !scene->tried_reciprocals)
        make_reciprocals(scene);
    if (snapped && !scene->tried_triangles)
        make_triangles(scene);
    if (logarithms && !scene->tried_logarithms)
        make_logarithms(scene);
    return (reciprocals && !scene->reciprocals) || (snapped && !scene->triangles)
         ? SCENE_RECIPROCALS
         : logarithms && !scene->logarithms ? SCENE_LOGARITHMS : SCENE_MADE;
}
