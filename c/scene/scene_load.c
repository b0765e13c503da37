#include "scene/scene.h"

#include "system/file.h"
#include "system/system.h"
#include "system/text.h"

static int32 refuse(const char *name, const char *field)
{
    text_add(name);
    return text_refuse(": not a usable scene file", field);
}

/* Behind the header, inside the file, and not too long. */
static int32 table_usable(uint32 at, uint32 count, uint32 size, uint32 bytes)
{
    return at >= sizeof(struct scene_header) && count <= SCENE_COUNT_MAX
        && table_inside(at, count, size, bytes);
}

/* The name of the first field that is wrong, or 0. */
static const char *wrong_header(const struct scene_header *h, uint32 bytes)
{
    const uint32 summed = (uint32)((const uint8 *)&h->width - (const uint8 *)h);

    if (bytes < sizeof *h)
        return "size";
    if (h->magic != SCENE_MAGIC)
        return "magic";
    if (h->version != SCENE_VERSION)
        return "version";
    if (h->size != bytes)
        return "size";
    if (h->checksum != crc32((const uint8 *)h + summed, bytes - summed))
        return "checksum";
    if (h->width < 4 || h->width > SCENE_SIDE_MAX || h->width & 3)
        return "width";
    if (h->height < 1 || h->height > SCENE_SIDE_MAX)
        return "height";
    if (h->frames < 1 || h->frames > SCENE_FRAMES_MAX)
        return "frames";
    if (h->background > 255)
        return "background";
    if (!table_usable(h->palette_at, 256, 4, bytes))
        return "palette_at";
    if (!table_usable(h->textures_at, h->textures, MAP_BYTES, bytes))
        return "textures or textures_at";
    if (!table_usable(h->materials_at, h->materials, sizeof(struct scene_material), bytes))
        return "materials or materials_at";
    if (!table_usable(h->objects_at, h->objects, sizeof(struct scene_object), bytes))
        return "objects or objects_at";
    if (!table_usable(h->vertices_at, h->vertices, sizeof(struct scene_vertex), bytes))
        return "vertices or vertices_at";
    if (!table_usable(h->poses_at, h->poses, sizeof(struct scene_pose), bytes))
        return "poses or poses_at";
    return 0;
}

static const char *wrong_entries(const struct scene *scene)
{
    const struct scene_header *h = scene->header;

    for (uint32 i = 0; i < h->materials; i++) {
        const struct scene_material *m = &scene->materials[i];

        if (m->texture != NO_TEXTURE && (uint32)m->texture >= h->textures)
            return "material.texture";
        if (m->colour > 255)
            return "material.colour";
    }
    for (uint32 i = 0; i < h->objects; i++) {
        const struct scene_object *o = &scene->objects[i];

        if (o->material >= h->materials)
            return "object.material";
        if (o->vertices < 3 || o->vertices > POLYGON_VERTICES_MAX || o->vertex > h->vertices
            || o->vertices > h->vertices - o->vertex)
            return "object.vertices";
        if (o->poses < 1 || o->pose > h->poses || o->poses > h->poses - o->pose)
            return "object.poses";
        if (o->first_frame >= (uint32)h->frames)
            return "object.first_frame";
    }
    return 0;
}

int32 scene_load(struct scene *scene, const char *name, int32 kind)
{
    const struct scene_header *header;
    const char *wrong;
    uint8 *data, *maps;
    uint32 bytes;

    if (!file_load(name, &data, &bytes))
        return 0;
    scene->header = header = (const struct scene_header *)data;
    wrong = wrong_header(header, bytes);
    if (wrong)
        return refuse(name, wrong);
    scene->materials = (const struct scene_material *)(data + header->materials_at);
    scene->objects = (const struct scene_object *)(data + header->objects_at);
    scene->vertices = (const struct scene_vertex *)(data + header->vertices_at);
    scene->poses = (const struct scene_pose *)(data + header->poses_at);
    wrong = wrong_entries(scene);
    if (wrong)
        return refuse(name, wrong);
    scene->maps = 0;
    if (header->textures) {
        const uint32 *from = (const uint32 *)(data + header->textures_at);
        uint32 longs = header->textures * (MAP_BYTES / 4);
        uint32 *to;

        if (!mem_alloc(&maps, (int32)((header->textures + 1) * MAP_BYTES), kind))
            return text_refuse(name, "not enough memory for the textures");
        scene->maps = maps + ((0 - (uint32)maps) & (MAP_BYTES - 1));
        for (to = (uint32 *)scene->maps; longs; longs--)
            *to++ = *from++;
    }
    return 1;
}
