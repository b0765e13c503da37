#include "scene/scene.h"

#include "polygon/math.h"
#include "polygon/tolerance.h"
#include "span/logarithm.h"
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

static uint32 pixel_max(const struct scene_header *h)
{
    return h->pixel_bytes == 2 ? 0xffff : 0xff;
}

/* The name of the first field that is wrong, or 0; so below. */
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
    if (h->pixel_bytes != 1 && h->pixel_bytes != 2)
        return "pixel_bytes";
    if (h->background > pixel_max(h))
        return "background";
    if (!table_usable(h->palette_at, 256, 4, bytes))
        return "palette_at";
    if (!table_usable(h->textures_at, h->textures, sizeof(struct scene_texture), bytes))
        return "textures or textures_at";
    if (!table_usable(h->materials_at, h->materials, sizeof(struct scene_material), bytes))
        return "materials or materials_at";
    if (!table_usable(h->objects_at, h->objects, sizeof(struct scene_object), bytes))
        return "objects or objects_at";
    if (!table_usable(h->vertices_at, h->vertices, sizeof(struct vertex), bytes))
        return "vertices or vertices_at";
    if (!table_usable(h->poses_at, h->poses, sizeof(struct scene_pose), bytes))
        return "poses or poses_at";
    if (!table_usable(h->points_at, h->points, sizeof(struct scene_point), bytes))
        return "points or points_at";
    if (!table_usable(h->normals_at, h->normals, sizeof(struct scene_normal), bytes))
        return "normals or normals_at";
    if (!table_usable(h->corners_at, h->corners, sizeof(struct scene_corner), bytes))
        return "corners or corners_at";
    if (!table_usable(h->faces_at, h->faces, sizeof(struct scene_face), bytes))
        return "faces or faces_at";
    if (!table_usable(h->meshes_at, h->meshes, sizeof(struct scene_mesh), bytes))
        return "meshes or meshes_at";
    if (!table_usable(h->instances_at, h->instances, sizeof(struct scene_instance), bytes))
        return "instances or instances_at";
    if (!table_usable(h->views_at, h->views, sizeof(struct scene_view), bytes))
        return "views or views_at";
    return 0;
}

static int32 is_power_of_two(int32 side)
{
    return !(side & (side - 1));
}

static int32 size_usable(int32 width, int32 height, enum map_layout layout)
{
    int32 smaller = width < height ? width : height, larger = width < height ? height : width;

    switch (layout) {
    case MAP_PAGE:
        return smaller >= MAP_SIDE_MIN && larger <= MAP_PAGE_SIDE
            && is_power_of_two(width) && is_power_of_two(height);
    case MAP_LINEAR:
        return smaller >= 1 && larger <= MAP_LINEAR_MAX;
    case MAP_COLUMNS:
        return smaller >= MAP_SIDE_MIN && larger <= 1 << (MAP_COLUMNS_BITS - 3)
            && is_power_of_two(width) && is_power_of_two(height)
            && width * height <= 1 << MAP_COLUMNS_BITS;
    case MAP_LIGHT:
        return width == MAP_PAGE_SIDE && height == LIGHT_LEVELS;
    default:
        return smaller == MAP_PAGE_SIDE && larger == MAP_PAGE_SIDE;
    }
}

static const char *wrong_texture(const struct scene *scene)
{
    const struct scene_header *h = scene->header;

    for (uint32 i = 0; i < h->textures; i++) {
        const struct scene_texture *t = &scene->textures[i];

        if (t->layout >= MAP_LAYOUTS || (h->pixel_bytes == 2 && t->layout != MAP_COLUMNS))
            return "texture.layout";
        if (t->texel_bytes != h->pixel_bytes)
            return "texture.texel_bytes";
        if (!size_usable(t->width, t->height, (enum map_layout)t->layout))
            return "texture.width or texture.height";
        if (t->at < sizeof *h
            || !table_inside(t->at, (uint32)(t->width * t->height), t->texel_bytes, h->size))
            return "texture.at";
    }
    return 0;
}

static int32 is_lit(uint32 mapper)
{
    return mapper == MAPPER_LIT || mapper == MAPPER_LIT_GOURAUD;
}

static const char *wrong_material(const struct scene *scene)
{
    /* What each mapper wants; MAP_LAYOUTS: none. */
    static const uint8 layouts[MAPPER_KINDS] = {
        MAP_LAYOUTS, MAP_LAYOUTS, MAP_PAGE, MAP_LINEAR, MAP_TILED, MAP_COLUMNS, MAP_MARGINS,
        MAP_PAGE, MAP_PAGE
    };
    const struct scene_header *h = scene->header;

    for (uint32 i = 0; i < h->materials; i++) {
        const struct scene_material *m = &scene->materials[i];

        if (m->mapper >= MAPPER_KINDS
            || (h->pixel_bytes == 2 && m->mapper != MAPPER_FLAT && m->mapper != MAPPER_COLUMNS))
            return "material.mapper";
        if (m->edges >= EDGES_KINDS)
            return "material.edges";
        if (m->gradients >= GRADIENTS_KINDS
            || (m->mapper == MAPPER_LIT_GOURAUD && m->gradients != GRADIENTS_PLANE))
            return "material.gradients";
        if (m->start >= START_KINDS
            || (m->mapper == MAPPER_LIT_GOURAUD && m->start != START_SUBTEXEL))
            return "material.start";
        if (m->clip >= CLIP_KINDS)
            return "material.clip";
        if (m->perspective >= PERSPECTIVE_KINDS
            || (m->perspective && (m->mapper != MAPPER_AFFINE || m->start != START_SUBTEXEL
                                   || m->gradients != GRADIENTS_PLANE)))
            return "material.perspective";
        if (m->tolerance < 0 || m->tolerance > TOLERANCE_MAX || (m->tolerance && !m->perspective))
            return "material.tolerance";
        if (layouts[m->mapper] == MAP_LAYOUTS ? m->texture != NO_TEXTURE
            : (uint32)m->texture >= h->textures
              || scene->textures[m->texture].layout != layouts[m->mapper])
            return "material.texture";
        if (is_lit(m->mapper) ? (uint32)m->light >= h->textures
                                || scene->textures[m->light].layout != MAP_LIGHT
            : m->light != NO_TEXTURE)
            return "material.light";
        if (m->colour > pixel_max(h))
            return "material.colour";
    }
    return 0;
}

const char *scene_wrong_texel(const struct scene *scene, const struct scene_material *material,
                              fix16 s, fix16 t)
{
    const struct scene_texture *map = &scene->textures[material->texture];
    fix16 scale = map_scale(map->width, map->height);

    if (s < 0 || s > 256 << 16 || mul_fix(s, scale) > map->width << 16)
        return "s";
    if (t < 0 || t > 256 << 16 || mul_fix(t, scale) > map->height << 16)
        return "t";
    return 0;
}

/* Only what a mapper does not repeat: texels inside the map, shades inside the palette. */
static const char *wrong_vertex(const struct scene *scene, const struct scene_object *object)
{
    const struct scene_material *m = &scene->materials[object->material];
    const struct vertex *v = &scene->vertices[object->vertex];

    for (uint32 left = object->vertices; left; left--, v++) {
        if ((m->mapper == MAPPER_GOURAUD || is_lit(m->mapper))
            && (v->shade < 0 || v->shade >= 256 << 16))
            return "vertex.shade";
        if (m->perspective && (v->w < W_MIN || v->w > W_MAX))
            return "vertex.w";
        if (m->mapper == MAPPER_ARBITRARY) {
            const char *wrong = scene_wrong_texel(scene, m, v->s, v->t);

            if (wrong)
                return *wrong == 's' ? "vertex.s" : "vertex.t";
        }
    }
    return 0;
}

static const char *wrong_object(const struct scene *scene)
{
    const struct scene_header *h = scene->header;

    for (uint32 i = 0; i < h->objects; i++) {
        const struct scene_object *o = &scene->objects[i];
        const struct scene_material *m;
        const char *wrong;

        if (o->material >= h->materials)
            return "object.material";
        m = &scene->materials[o->material];
        if (o->vertices < 3 || o->vertices > POLYGON_VERTICES_MAX || o->vertex > h->vertices
            || o->vertices > h->vertices - o->vertex
            || (o->vertices > 3 && m->mapper != MAPPER_FLAT && m->gradients == GRADIENTS_POLYGON))
            return "object.vertices";
        if (o->poses < 1 || o->pose > h->poses || o->poses > h->poses - o->pose)
            return "object.poses";
        if (o->first_frame >= (uint32)h->frames)
            return "object.first_frame";
        wrong = wrong_vertex(scene, o);
        if (wrong)
            return wrong;
    }
    return 0;
}

static const char *wrong_entry(const struct scene *scene)
{
    const char *wrong = wrong_texture(scene);

    if (!wrong)
        wrong = wrong_material(scene);
    if (!wrong)
        wrong = wrong_object(scene);
    return wrong ? wrong : scene_wrong_mesh(scene);
}

static int32 needs_reciprocals(const struct scene_material *material)
{
    return material->perspective == PERSPECTIVE_EVERY16
        || material->perspective == PERSPECTIVE_EVERY8 || material->tolerance;
}

static int32 needs_logarithms(const struct scene_material *material)
{
    return material->perspective == PERSPECTIVE_PIXEL;
}

static int32 is_needed(const struct scene *scene, int32 (*needs)(const struct scene_material *))
{
    for (uint32 i = 0; i < scene->header->materials; i++)
        if (needs(&scene->materials[i]))
            return 1;
    return 0;
}

/* The table of reciprocals, where a material needs it. */
static int32 make_reciprocals(struct scene *scene)
{
    uint16 *table;

    scene->reciprocals = 0;
    if (!is_needed(scene, needs_reciprocals))
        return 1;
    if (!mem_alloc(&table, RECIPROCAL_COUNT * sizeof *table, MEMORY_ANY))
        return 0;
    scene->reciprocals = reciprocals_make(table);
    return 1;
}

/* Logarithms and powers alike, 673 KB. */
static int32 make_logarithms(struct scene *scene)
{
    struct logarithm_tables *tables;
    int16 *logs;
    uint16 *powers;

    scene->logarithms = 0;
    if (!is_needed(scene, needs_logarithms))
        return 1;
    if (!mem_alloc(&powers, LOGARITHM_POWERS * sizeof *powers, MEMORY_ANY)
        || !mem_alloc(&logs, LOGARITHM_COUNT * sizeof *logs, MEMORY_ANY)
        || !mem_alloc(&tables, sizeof *tables, MEMORY_ANY))
        return 0;
    logarithms_make(tables, logs, powers);
    scene->logarithms = tables;
    return 1;
}

static int32 make_materials(struct scene *scene)
{
    uint32 count = scene->header->materials;
    const struct scene_material *from = scene->materials;
    struct material *to;

    if (!mem_alloc(&scene->drawn, (int32)(count * sizeof *to), MEMORY_ANY))
        return 0;
    to = scene->drawn;
    for (uint32 i = 0; i < count; i++, from++, to++) {
        to->mapper = (uint8)from->mapper;
        to->edges = (uint8)from->edges;
        to->gradients = (uint8)from->gradients;
        to->start = (uint8)from->start;
        to->clip = (uint8)from->clip;
        to->perspective = (uint8)from->perspective;
        to->number = (uint16)i;
        to->tolerance = from->tolerance;
        to->colour = from->colour;
        to->reciprocals = needs_reciprocals(from) ? scene->reciprocals : 0;
        to->logarithms = needs_logarithms(from) ? scene->logarithms : 0;
        to->map = from->texture == NO_TEXTURE ? 0 : &scene->maps[from->texture];
        to->light = from->light == NO_TEXTURE ? 0 : &scene->maps[from->light];
    }
    return 1;
}

int32 scene_load(struct scene *scene, const char *name, int32 kind)
{
    const struct scene_header *header;
    const char *wrong;
    uint8 *data;
    uint32 bytes;

    if (!file_load(name, &data, &bytes))
        return 0;
    scene->header = header = (const struct scene_header *)data;
    wrong = wrong_header(header, bytes);
    if (wrong)
        return refuse(name, wrong);
    scene->textures = (const struct scene_texture *)(data + header->textures_at);
    scene->materials = (const struct scene_material *)(data + header->materials_at);
    scene->objects = (const struct scene_object *)(data + header->objects_at);
    scene->vertices = (const struct vertex *)(data + header->vertices_at);
    scene->poses = (const struct scene_pose *)(data + header->poses_at);
    scene->points = (const struct scene_point *)(data + header->points_at);
    scene->normals = (const struct scene_normal *)(data + header->normals_at);
    scene->corners = (const struct scene_corner *)(data + header->corners_at);
    scene->faces = (const struct scene_face *)(data + header->faces_at);
    scene->meshes = (const struct scene_mesh *)(data + header->meshes_at);
    scene->instances = (const struct scene_instance *)(data + header->instances_at);
    scene->views = (const struct scene_view *)(data + header->views_at);
    wrong = wrong_entry(scene);
    if (wrong)
        return refuse(name, wrong);
    if (!scene_make_maps(scene, kind))
        return text_refuse(name, "not enough memory for the textures");
    if (!make_reciprocals(scene))
        return text_refuse(name, "not enough memory for the reciprocals of perspective");
    if (!make_logarithms(scene))
        return text_refuse(name, "not enough memory for the logarithms of perspective");
    if (!make_materials(scene))
        return text_refuse(name, "not enough memory for the materials");
    if (!scene_make_work(scene))
        return text_refuse(name, "not enough memory for the meshes");
    return 1;
}
