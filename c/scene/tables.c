#include "scene/tables.h"

#include "scene/load.h"
#include "span/far.h"
#include "system/system.h"
#include "triangle/triangles.h"

/* Tables that a scene may need. */
enum { RECIPROCALS = 1, SNAPPED = 2 };

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

enum scene_memory scene_make_tables(struct scene *scene)
{
    const uint32 needed = tables_needed(scene);

    if (needed & RECIPROCALS && !scene->tried_reciprocals)
        make_reciprocals(scene);
    if (needed & SNAPPED && !scene->tried_triangles)
        make_triangles(scene);
    return (needed & RECIPROCALS && !scene->reciprocals) || (needed & SNAPPED && !scene->triangles)
         ? SCENE_RECIPROCALS : SCENE_MADE;
}
