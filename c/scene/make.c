/* Prepares a scene in memory for drawing, but its maps; nothing here checks it. */
#include "scene/load.h"

#include "scene/maps.h"
#include "scene/tables.h"
#include "system/system.h"

int32 scene_pixel_bytes(uint32 format)
{
    static const uint8 bytes[PIXEL_FORMATS] = {
        [PIXEL_CHUNKY] = 1, [PIXEL_RGB565] = 2, [PIXEL_RGBA5551] = 2, [PIXEL_RGBA8888] = 4
    };

    return bytes[format];
}

void scene_place(struct scene *scene, const uint8 *data)
{
    const struct scene_header *header = (const struct scene_header *)data;

    scene->header = header;
#define TABLE(name, type) scene->name = (const struct type *)(data + header->name##_at);
#define BLOCK(name)
    TABLE_LIST(TABLE, BLOCK)
#undef TABLE
#undef BLOCK
}

static polygon_routine *routine_of(const struct scene *scene,
                                   const struct scene_material *material)
{
    if (material->mapper == MAPPER_N64)
        return scene_unit_routine(material->primitive);
    if (material->mapper == MAPPER_GLIDE)
        return scene_pipe_routine(scene, material);
    return polygon_draw;
}

static enum scene_memory make_materials(struct scene *scene)
{
    uint32 count = scene->header->materials, levels = 0, keyed = 0;
    const struct scene_material *from = scene->materials;
    struct material *to;

    if (!mem_alloc(&scene->drawn, (int32)(count * sizeof *to), MEMORY_ANY))
        return SCENE_MATERIALS;
    to = scene->drawn;
    for (uint32 i = 0; i < count; i++, from++, to++) {
        to->mapper = (uint8)from->mapper;
        to->edges = (uint8)from->edges;
        to->gradients = (uint8)from->gradients;
        to->start = (uint8)from->start;
        to->clip = (uint8)from->clip;
        to->perspective = (uint8)from->perspective;
        to->whole = 0;
        to->levels = 0;
        levels |= from->levels;
        keyed |= from->mapper == MAPPER_KEYED;
        to->number = (uint16)i;
        to->tolerance = from->tolerance;
        to->colour = from->colour;
        to->draw = routine_of(scene, from);
        to->unit = from->mapper == MAPPER_N64 ? &scene->engines[from->unit] : 0;
        to->pipe = from->mapper == MAPPER_GLIDE ? &scene->pipe[from->unit] : 0;
        to->map = from->texture == NO_TEXTURE ? 0 : &scene->maps[from->texture];
        to->light = from->light == NO_TEXTURE ? 0 : &scene->maps[from->light];
    }
    if (levels)
        scene_make_levels(scene);
    return keyed && !scene_make_rows(scene) ? SCENE_TEXTURES : SCENE_MADE;
}

static uint32 larger(uint32 a, uint32 b)
{
    return a > b ? a : b;
}

/* Converts all points to 16 bits, each mesh in its unit, if a view takes them. */
static int32 make_points16(struct scene *scene)
{
    const struct scene_mesh *mesh = scene->meshes;

    scene->points16 = 0;
    if (!scene->header->views16)
        return 1;
    if (!mem_alloc(&scene->points16,
                   (int32)(scene->header->points * sizeof *scene->points16), MEMORY_ANY))
        return 0;
    for (uint32 i = scene->header->meshes; i; i--, mesh++)
        mesh_points16(&scene->points16[mesh->point], &scene->points[mesh->point],
                      (int32)mesh->points);
    return 1;
}

/* Marks the meshes whose corners all have the normal of their point's number. */
static int32 make_smooth(struct scene *scene)
{
    const uint32 count = scene->header->meshes;
    const struct scene_mesh *mesh = scene->meshes;

    if (!mem_alloc(&scene->smooth, (int32)count, MEMORY_ANY))
        return 0;
    for (uint32 i = 0; i < count; i++, mesh++) {
        const struct scene_corner *corner = &scene->corners[mesh->corner];
        uint8 is_smooth = mesh->points == mesh->normals;

        for (uint32 left = mesh->corners; left && is_smooth; left--, corner++)
            is_smooth = corner->point == corner->normal;
        scene->smooth[i] = is_smooth;
    }
    return 1;
}

/* Makes memory for the largest tree; there may be none. */
static int32 make_trees(struct scene *scene)
{
    struct mesh_work *work = &scene->work;
    uint32 root = 0, slots = 0, nodes = 0;

    work->slots = 0;
    work->steps = 0;
    while (root < scene->header->nodes) {
        const struct scene_node *node = &scene->nodes[root];
        const uint32 count = 1 + node->front + node->back;
        const struct scene_node *const last = node + count - 1;

        nodes = larger(nodes, count);
        slots = larger(slots, last->slot + last->slots);
        root += count;
    }
    if (!nodes)
        return 1;
    if (!mem_alloc(&work->slots, (int32)(slots * sizeof *work->slots), MEMORY_ANY)
        || !mem_alloc(&work->steps, (int32)(2 * nodes * sizeof *work->steps), MEMORY_ANY))
        return 0;
    while (slots > 0)
        work->slots[--slots] = 0;
    return 1;
}

/* Makes the z buffer and the frame aside, if an instance needs them. */
static int32 make_depths(struct scene *scene)
{
    const int32 width = scene->header->width, height = scene->header->height;
    const struct scene_instance *o = scene->instances;
    struct depths *depths;
    uint32 left = scene->header->instances;

    scene->depths = 0;
    while (left && o->tree != TREE_Z) {
        left--;
        o++;
    }
    if (!left)
        return 1;
    if (!mem_alloc(&scene->depths, sizeof *depths, MEMORY_ANY))
        return 0;
    depths = scene->depths;
    depths->near_plane = scene->header->near_plane;
    depths->aside.width = depths->aside.pitch = width;
    depths->aside.height = height;
    depths->aside.pixel_bytes = 1;
    return mem_alloc(&depths->z, width * height * (int32)sizeof *depths->z, MEMORY_ANY)
        && mem_alloc(&depths->bounds, height * (int32)sizeof *depths->bounds, MEMORY_ANY)
        && mem_alloc(&depths->aside.pixels, width * height, MEMORY_ANY);
}

static enum scene_memory make_work(struct scene *scene)
{
    const struct scene_instance *o = scene->instances;
    uint32 instances = 0, points = 0, normals = 0, faces = 0;
    uint32 most_instances = 0, most_points = 0, most_normals = 0, most_faces = 0;
    struct mesh_work *work = &scene->work;

    if (!scene->header->instances)
        return SCENE_MADE;
    if (!scene_make_coverage(scene))
        return SCENE_COVERAGE;
    for (uint32 i = 0; i < scene->header->instances; i++, o++) {
        const struct scene_mesh *mesh = &scene->meshes[o->mesh];

        if (i && o->before != o[-1].before)
            instances = points = normals = faces = 0;
        instances++;
        points += mesh->points;
        normals += mesh->normals;
        faces += mesh->faces;
        most_instances = larger(most_instances, instances);
        most_points = larger(most_points, points);
        most_normals = larger(most_normals, normals);
        most_faces = larger(most_faces, faces);
        if (larger(points, larger(normals, faces)) > SCENE_COUNT_MAX)
            return SCENE_CROWDED;
    }
    return mem_alloc(&work->placed, (int32)(most_instances * sizeof *work->placed), MEMORY_ANY)
        && mem_alloc(&work->points, (int32)(most_points * sizeof *work->points), MEMORY_ANY)
        && mem_alloc(&work->places, (int32)(most_points * sizeof *work->places), MEMORY_ANY)
        && mem_alloc(&work->attributes, (int32)(most_normals * sizeof *work->attributes),
                     MEMORY_ANY)
        && mem_alloc(&work->faces, (int32)(most_faces * sizeof *work->faces), MEMORY_ANY)
        && mem_alloc(&work->marks, (int32)(most_points + 4) & ~3, MEMORY_ANY)
        && make_points16(scene) && make_smooth(scene) && make_trees(scene)
        && scene_make_near(scene) && make_depths(scene)
        ? SCENE_MADE : SCENE_MESHES;
}

enum scene_memory scene_make(struct scene *scene, int32 kind)
{
    enum scene_memory made;

    scene->touched = 0;
    scene->is_coarse = 0;
    scene->reciprocals = 0;
    scene->triangles = 0;
    scene->tried_reciprocals = scene->tried_triangles = 0;
    if ((scene->header->units && !scene_make_units(scene, kind))
        || (scene->header->pipes && !scene_make_pipes(scene, kind)))
        return SCENE_UNITS;
    made = make_materials(scene);
    if (made != SCENE_MADE)
        return made;
    if (!mem_alloc(&scene->scratch, sizeof *scene->scratch, MEMORY_ANY))
        return SCENE_MATERIALS;
    made = scene_make_tables(scene);
    return made == SCENE_MADE ? make_work(scene) : made;
}

void scene_reserve(const struct scene *scene)
{
    if (scene->header->units | scene->header->pipes)
        mem_reserve();
}
