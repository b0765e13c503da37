#include "scene/tables.h"

#include "span/logarithm.h"
#include "system/system.h"

int32 scene_make_reciprocals(struct scene *scene)
{
    uint16 *table;

    if (!mem_alloc(&table, RECIPROCAL_COUNT * sizeof *table, MEMORY_ANY))
        return 0;
    scene->reciprocals = reciprocals_make(table);
    return 1;
}

int32 scene_make_logarithms(struct scene *scene)
{
    struct logarithm_tables *tables;
    int16 *logs;
    uint16 *powers;

    if (!mem_alloc(&powers, LOGARITHM_POWERS * sizeof *powers, MEMORY_ANY)
        || !mem_alloc(&logs, LOGARITHM_COUNT * sizeof *logs, MEMORY_ANY)
        || !mem_alloc(&tables, sizeof *tables, MEMORY_ANY))
        return 0;
    logarithms_make(tables, logs, powers);
    scene->logarithms = tables;
    return 1;
}
