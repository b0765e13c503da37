#include "scene/settings.h"

#include "polygon/kind.h"
#include "scene/load.h"
#include "scene/tables.h"

static const struct {
    uint8 edges, gradients, start;
} accuracy[ACCURACY_STEPS] = {
    {EDGES_INTEGER, GRADIENTS_POLYGON, START_TRUNCATED},
    {EDGES_SUBPIXEL, GRADIENTS_POLYGON, START_TRUNCATED},
    {EDGES_SUBPIXEL, GRADIENTS_POLYGON, START_SUBTEXEL},
    {EDGES_SUBPIXEL, GRADIENTS_PLANE, START_SUBTEXEL},
    {EDGES_SNAPPED, GRADIENTS_PLANE, START_SUBTEXEL},
    {EDGES_EXACT, GRADIENTS_PLANE, START_SUBTEXEL}
};

/* Names are apart: only a program that shows them holds them. */
static const char *const accuracy_names[ACCURACY_STEPS] = {
    "integer, polygon, truncated", "subpixel, polygon, truncated", "subpixel, polygon, subtexel",
    "subpixel, plane, subtexel", "snapped, plane, subtexel", "exact, plane, subtexel"
};

/* Of Glide's units, by perspective. */
static const uint8 subdivisions[PERSPECTIVE_KINDS] = {16, 16, 8, 0, 0};
static const char *const perspective_names[PERSPECTIVE_KINDS] = {"none", "every16", "every8", "pixel", "fine"};

/* Returns non-zero if the mapper has fixed gradients and start. */
static int32 is_fixed(uint32 mapper)
{
    return mappers[mapper].is & (MAPPER_UNIT + MAPPER_PLANE);
}

static void set_perspective(struct material *to, const struct scene_material *from,
                            const struct settings *settings)
{
    const int32 step = settings->perspective;

    to->perspective = (uint8)from->perspective;
    to->tolerance = from->tolerance;
    if (step == SETTINGS_OWN || !from->perspective
        || (settings->only_cheaper && step >= (int32)from->perspective))
        return;
    to->perspective = (uint8)step;
    if (step == PERSPECTIVE_FINE)
        to->tolerance = 0;
}

/* Called after set_perspective, whose result it reads. */
static void set_accuracy(struct material *to, const struct scene_material *from,
                         const struct settings *settings)
{
    const int32 step = settings->accuracy;

    to->edges = (uint8)from->edges;
    to->gradients = (uint8)from->gradients;
    to->start = (uint8)from->start;
    if (step == SETTINGS_OWN
        || (settings->only_cheaper && (to->edges == EDGES_INTEGER || to->edges == EDGES_SNAPPED)))
        return;
    to->edges = accuracy[step].edges;
    if (mappers[from->mapper].is & MAPPER_UNIT
        && (to->edges == EDGES_INTEGER || to->edges == EDGES_SNAPPED))
        to->edges = EDGES_SUBPIXEL;
    if (is_fixed(from->mapper) || to->perspective)
        return;
    to->gradients = accuracy[step].gradients;
    to->start = accuracy[step].start;
}

static int32 has_triangles_only(const struct scene *scene, const struct scene_mesh *mesh)
{
    const struct scene_face *face = &scene->faces[mesh->face];

    for (uint32 i = mesh->faces; i; i--, face++)
        if (face->corners > 3)
            return 0;
    return 1;
}

static void keep_gradients(const struct scene *scene, uint32 material)
{
    const struct scene_material *from = &scene->materials[material];

    scene->drawn[material].gradients = (uint8)from->gradients;
    for (uint32 i = from->levels; i; i--)
        scene->drawn[from->level + i - 1].gradients = (uint8)from->gradients;
}

/* Restores the gradients of materials with polygons or faces of more than three corners. */
static void restore_gradients(const struct scene *scene)
{
    const struct scene_object *object = scene->objects;
    const struct scene_instance *instance = scene->instances;

    for (uint32 i = scene->header->objects; i; i--, object++)
        if (object->vertices > 3)
            keep_gradients(scene, object->material);
    for (uint32 i = scene->header->instances; i; i--, instance++)
        if (!has_triangles_only(scene, &scene->meshes[instance->mesh]))
            keep_gradients(scene, instance->material);
}

/* Returns the pixels between two divides of a Glide unit; own: the scene's. 0: none, so the dearest. */
static uint32 subdivision(uint32 own, const struct settings *settings)
{
    const int32 step = settings->perspective;
    const uint32 asked = step == SETTINGS_OWN ? own : subdivisions[step];

    return settings->only_cheaper && own && asked < own ? own : asked;
}

static void set_units(struct scene *scene, const struct settings *settings)
{
    for (uint32 i = 0; i < scene->header->glide_units; i++)
        glide_subdivision(&scene->glide[i], subdivision(scene->glide_units[i].subdivision, settings));
}

int32 settings_set(struct scene *scene, const struct settings *settings)
{
    for (uint32 i = 0; i < scene->header->materials; i++) {
        set_perspective(&scene->drawn[i], &scene->materials[i], settings);
        set_accuracy(&scene->drawn[i], &scene->materials[i], settings);
    }
    restore_gradients(scene);
    scene->is_once = scene->header->once && (settings->accuracy == SETTINGS_OWN
                                             || accuracy[settings->accuracy].edges == EDGES_EXACT);
    set_units(scene, settings);
    return scene_make_tables(scene) == SCENE_MADE;
}

/* Returns 1 if an object of the screen's space has a material. */
static int32 is_flat(const struct scene *scene, uint32 material)
{
    for (uint32 i = 0; i < scene->header->objects; i++)
        if (scene->objects[i].material == material)
            return 1;
    return 0;
}

/* Gives perspective to the materials without it that meshes alone have, and to their mip maps'. */
static void set_depths(const struct scene *scene)
{
    for (uint32 i = 0; i < scene->header->instances; i++) {
        const uint32 number = scene->instances[i].material;
        const struct scene_material *from = &scene->materials[number];

        if (from->perspective || !(mappers[from->mapper].is & MAPPER_PERSPECTIVE) || is_flat(scene, number))
            continue;
        for (uint32 level = 0; level <= from->levels; level++) {
            struct material *to = &scene->drawn[level ? from->level + level - 1 : number];

            to->perspective = PERSPECTIVE_FINE;
            to->gradients = GRADIENTS_PLANE;
            to->start = START_SUBTEXEL;
        }
    }
}

void settings_set_exact(struct scene *scene)
{
    static const struct settings best = {ACCURACY_STEPS - 1, PERSPECTIVE_FINE, 0};

    settings_set(scene, &best);
    set_depths(scene);
    scene_make_tables(scene);
}

const char *settings_accuracy(int32 step)
{
    return step == SETTINGS_OWN ? "settings of the scene" : accuracy_names[step];
}

const char *settings_perspective(int32 step)
{
    return step == SETTINGS_OWN ? "of the scene" : perspective_names[step];
}
