#include "scene/maps.h"

#include "math/math.h"
#include "perspective/tolerance.h"
#include "polygon/kind.h"
#include "scene/load.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

static int32 refuse(const char *name, const char *field)
{
    text_add(name);
    return text_refuse(": not a usable scene file", field);
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

/* Returns the name of the first field that is wrong, or 0; so do all wrong_ functions below. */
static const char *wrong_texture(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    int32 bytes = scene_pixel_bytes(h->format);

    uint32 at = scene_tables_end(h);

    for (uint32 i = 0; i < h->textures; i++) {
        const struct scene_texture *t = &scene->textures[i];

        if (t->layout >= MAP_LAYOUTS || (bytes > 1 && t->layout != MAP_PAGE
                                         && (bytes > 2 || t->layout != MAP_COLUMNS)))
            return "texture.layout";
        if (t->texel_bytes != (uint32)bytes)
            return "texture.texel_bytes";
        if (!size_usable(t->width, t->height, (enum map_layout)t->layout))
            return "texture.width or texture.height";
        if (t->at != at
            || !table_inside(at, (uint32)(t->width * t->height), t->texel_bytes, h->size))
            return "texture.at";
        at += ((uint32)(t->width * t->height) * t->texel_bytes + 3) & ~(uint32)3;
    }
    return 0;
}

static int32 is(uint32 mapper, enum mapper_trait trait)
{
    return (mappers[mapper].is & trait) != 0;
}

/* Returns non-zero if a mapper draws pixels of a format. */
static int32 draws(uint32 mapper, uint32 format)
{
    const int32 bytes = scene_pixel_bytes(format);

    if (bytes == 2 && is(mapper, MAPPER_UNIT)
        && format != (mapper == MAPPER_N64 ? PIXEL_RGBA5551 : PIXEL_RGB565))
        return 0;
    return mappers[mapper].bytes & bytes;
}

/* Returns 1 if the unit of a material exists, or if it needs none and has none. */
static int32 unit_usable(const struct scene_header *h, const struct scene_material *m)
{
    if (!is(m->mapper, MAPPER_UNIT))
        return m->unit == NO_UNIT;
    return (uint32)m->unit < (m->mapper == MAPPER_N64 ? h->units : h->pipes);
}

/* Returns 1 if a texture has half the sides of another. */
static int32 is_half(const struct scene_texture *half, const struct scene_texture *whole)
{
    return 2 * half->width == whole->width && 2 * half->height == whole->height;
}

/* Returns 1 if the materials of a material's levels, if it has any, are behind it and as they should be. */
static int32 levels_usable(const struct scene *scene, const struct scene_material *m)
{
    const uint32 left = (uint32)(&scene->materials[scene->header->materials] - m);
    const uint32 ahead = m->level - (uint32)(m - scene->materials);
    const struct scene_material *level = m + ahead;
    const struct scene_texture *whole;

    if (!m->levels)
        return !m->level;
    if (mappers[m->mapper].layout != MAP_PAGE || m->mapper == MAPPER_KEYED || m->levels > MIPMAP_LEVELS_MAX
        || !ahead || ahead >= left || left - ahead < m->levels)
        return 0;
    whole = &scene->textures[m->texture];
    for (uint32 i = m->levels; i; i--, level++) {
        const struct scene_texture *half;

        if (level->levels || level->mapper != m->mapper || level->edges != m->edges
            || level->gradients != m->gradients || level->start != m->start || level->clip != m->clip
            || level->perspective != m->perspective || level->light != m->light
            || level->tolerance != m->tolerance || (uint32)level->texture >= scene->header->textures)
            return 0;
        half = &scene->textures[level->texture];
        if (half->layout != MAP_PAGE || !is_half(half, whole))
            return 0;
        whole = half;
    }
    return 1;
}

static const char *wrong_material(const struct scene *scene)
{
    const struct scene_header *h = scene->header;

    for (uint32 i = 0; i < h->materials; i++) {
        const struct scene_material *m = &scene->materials[i];

        if (m->mapper >= MAPPER_KINDS || !draws(m->mapper, h->format))
            return "material.mapper";
        if (!unit_usable(h, m))
            return "material.unit";
        if (m->primitive >= (m->mapper == MAPPER_N64 ? UNIT_PRIMITIVES : 1))
            return "material.primitive";
        if (m->edges >= EDGES_KINDS
            || (is(m->mapper, MAPPER_UNIT)
                && (m->edges == EDGES_INTEGER || m->edges == EDGES_SNAPPED)))
            return "material.edges";
        if (m->gradients >= GRADIENTS_KINDS
            || (is(m->mapper, MAPPER_PLANE) && m->gradients != GRADIENTS_PLANE))
            return "material.gradients";
        if (m->start >= START_KINDS
            || (is(m->mapper, MAPPER_PLANE) && m->start != START_SUBTEXEL))
            return "material.start";
        if (m->clip >= CLIP_KINDS)
            return "material.clip";
        if (m->perspective >= PERSPECTIVE_KINDS
            || (m->perspective && (!is(m->mapper, MAPPER_PERSPECTIVE)
                                   || m->start != START_SUBTEXEL
                                   || m->gradients != GRADIENTS_PLANE)))
            return "material.perspective";
        if (m->tolerance < 0 || m->tolerance > TOLERANCE_MAX || (m->tolerance && !m->perspective))
            return "material.tolerance";
        if (mappers[m->mapper].layout == MAP_LAYOUTS ? m->texture != NO_TEXTURE
            : (uint32)m->texture >= h->textures
              || scene->textures[m->texture].layout != mappers[m->mapper].layout)
            return "material.texture";
        if (is(m->mapper, MAPPER_LIGHTS) ? (uint32)m->light >= h->textures
                                || scene->textures[m->light].layout != MAP_LIGHT
            : m->light != NO_TEXTURE)
            return "material.light";
        if (!levels_usable(scene, m))
            return "material.levels";
        if (m->colour > scene_pixel_max(h))
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

/* Returns 1 if the objects of a material are rectangles. */
static int32 has_rectangles(const struct scene_material *material)
{
    return material->primitive >= UNIT_RECTANGLES;
}

static int32 is_fraction(int32 value)
{
    return (value & 0xffff) != 0;
}

static int32 is_short(int32 value)
{
    return value == (int16)value;
}

/* Checks a rectangle's vertices and poses: whole pixels, s10.5, s5.10, no rotation or scaling. */
static const char *wrong_rectangle(const struct scene *scene, const struct scene_object *object)
{
    const struct vertex *v = &scene->vertices[object->vertex];
    const struct scene_pose *pose = &scene->poses[object->pose];

    for (uint32 i = 0; i < 2; i++, v++) {
        if (is_fraction(v->x))
            return "vertex.x";
        if (is_fraction(v->y))
            return "vertex.y";
        if (!is_short(v->s))
            return "vertex.s";
        if (!is_short(v->t))
            return "vertex.t";
    }
    for (uint32 left = object->pose == NO_POSE ? 0 : object->poses; left; left--, pose++)
        if (pose->xx != 65536 || pose->yy != 65536 || pose->xy || pose->yx)
            return "pose.xx, xy, yx or yy";
        else if (is_fraction(pose->x0 | pose->y0))
            return "pose.x0 or y0";
    return 0;
}

static int32 depth_usable(fix16 w, int32 is_own)
{
    return is_own ? w && w >= -W_MAX && w <= W_MAX : w >= W_MIN && w <= W_MAX;
}

/* Checks shades and w, and for MAPPER_ARBITRARY, whose map does not repeat, s and t. */
static const char *wrong_vertex(const struct scene *scene, const struct scene_object *object)
{
    const struct scene_material *m = &scene->materials[object->material];
    const struct vertex *v = &scene->vertices[object->vertex];
    uint32 own = scene_has_own(scene, m) ? object->vertices >> 1 : 0;

    for (uint32 left = object->vertices; left; left--, v++) {
        if ((m->mapper == MAPPER_GOURAUD || is(m->mapper, MAPPER_LIGHTS))
            && (v->shade < 0 || v->shade >= 256 << 16))
            return "vertex.shade";
        if ((m->perspective || is(m->mapper, MAPPER_UNIT)) && !depth_usable(v->w, left <= own))
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
        if ((has_rectangles(m) ? o->vertices != 2 : o->vertices < 3)
            || o->vertices > POLYGON_VERTICES_MAX || o->vertex > h->vertices
            || o->vertices > h->vertices - o->vertex
            || (o->vertices > 3 && m->mapper != MAPPER_FLAT && m->gradients == GRADIENTS_POLYGON)
            || (scene_has_own(scene, m) && (o->vertices < 6 || o->vertices & 1)))
            return "object.vertices";
        if (o->poses < 1 || (o->pose != NO_POSE
                             && ((uint32)o->pose > h->poses || o->poses > h->poses - (uint32)o->pose)))
            return "object.poses";
        if (o->first_frame >= (uint32)h->frames)
            return "object.first_frame";
        if (o->planar > PLANAR_ALL)
            return "object.planar";
        wrong = wrong_vertex(scene, o);
        if (!wrong && has_rectangles(m))
            wrong = wrong_rectangle(scene, o);
        if (wrong)
            return wrong;
    }
    return 0;
}

static const char *wrong_entry(const struct scene *scene)
{
    const char *wrong = wrong_texture(scene);

    if (!wrong)
        wrong = scene_wrong_unit(scene);
    if (!wrong)
        wrong = scene_wrong_pipe(scene);
    if (!wrong)
        wrong = wrong_material(scene);
    if (!wrong)
        wrong = wrong_object(scene);
    if (!wrong)
        wrong = scene_wrong_mesh(scene);
    return wrong ? wrong : scene_wrong_once(scene);
}

/* Reads the header and the tables behind it into new memory. Returns the scene's file, or 0: *wrong is the
   first wrong field, or 0 if a line was printed. */
static const struct scene_header *read_tables(struct file_input *input, const char **wrong)
{
    struct scene_header start;
    const uint32 whole = input->left, unsummed = (uint32)((uint8 *)&start.width - (uint8 *)&start);
    uint32 bytes;
    uint8 *data;

    *wrong = 0;
    if (!file_input_read(input, &start, whole < sizeof start ? whole : (uint32)sizeof start))
        return 0;
    *wrong = scene_wrong_start(&start, whole);
    if (*wrong)
        return 0;
    input->sum = crc32(0, (uint8 *)&start + unsummed, (uint32)sizeof start - unsummed);
    *wrong = scene_wrong_header(&start);
    if (*wrong) {
        if (!file_input_sound(input, start.checksum))
            *wrong = "checksum";
        return 0;
    }
    bytes = scene_tables_end(&start);
    if (!mem_alloc(&data, (int32)bytes, MEMORY_ANY)) {
        outcome_lack_memory(input->name, "the tables");
        return 0;
    }
    for (uint32 i = 0; i < sizeof start; i++)
        data[i] = ((uint8 *)&start)[i];
    return file_input_read(input, data + sizeof start, bytes - (uint32)sizeof start)
        ? (const struct scene_header *)data : 0;
}

/* Reads and checks a scene and its maps; prints a line and returns 0 if it cannot. */
static int32 read_scene(struct scene *scene, struct file_input *input, int32 kind)
{
    const char *wrong;
    const struct scene_header *header = read_tables(input, &wrong);

    if (header) {
        scene_place(scene, (const uint8 *)header);
        wrong = wrong_entry(scene);
        if (!wrong) {
            if (!scene_take_maps(scene, kind))
                return outcome_lack_memory(input->name, "the textures");
            if (!scene_read_maps(scene, input))
                return 0;
        }
        if (!file_input_sound(input, header->checksum))
            wrong = "checksum";
    }
    return wrong ? refuse(input->name, wrong) : header != 0;
}

int32 scene_load(struct scene *scene, const char *name, int32 kind)
{
    static const char *const purposes[] = {
        "", "the transparent texels' rows", "the reciprocals", "the materials", "the meshes",
        "the texture units", "the coverage"
    };
    struct file_input input;
    enum scene_memory lacks;
    int32 is_read;

    if (!file_input_open(&input, name))
        return 0;
    is_read = read_scene(scene, &input, kind);
    file_close(input.file);
    if (!is_read)
        return 0;
    lacks = scene_make(scene, kind);
    if (lacks == SCENE_CROWDED)
        return refuse(name, "points, normals or faces of meshes between two objects");
    if (lacks != SCENE_MADE)
        return outcome_lack_memory(name, purposes[lacks]);
    return scene_try_units(scene, name);
}
