/* Turns instances into polygons. Every point is transformed to the camera and projected once.
   Faces seen from the back or wholly outside one border are dropped; the others are drawn from
   the farthest to the nearest, clipped if they cross a border. */
#include "scene/draw_meshes.h"

#include "drawing/fan.h"
#include "math/math.h"
#include "triangle/polygon.h"

/* Draws a polygon; with GRADIENTS_POLYGON as a fan of triangles, because clipping adds corners. */
static enum polygon_result draw_polygon(struct renderer *renderer, const struct vertex *vertices,
                                        int32 count, const struct material *material)
{
    struct polygon polygon;

    /* A face is a plane in space, but on the screen its affine texels need not be on a plane. */
    polygon_set(&polygon, vertices, count, PLANAR_ALL - PLANAR_TEXELS);
    if (count == 3 || material->mapper == MAPPER_FLAT
        || material->gradients != GRADIENTS_POLYGON)
        return material->draw(renderer, &polygon, material);
    return polygon_fan(material->draw, renderer, &polygon, material);
}

/* Projects vertices from camera space to the screen, as mesh_transform does. */
static void project(struct vertex *v, int32 count, const struct scene_header *header)
{
    int32 scale = 65536 << header->guard;

    for (; count > 0; count--, v++) {
        v->x = mul_div(v->x, scale, v->w) + (header->width << 15);
        v->y = mul_div(v->y, scale, v->w) + (header->height << 15);
    }
}

static enum polygon_result draw_cut(struct renderer *renderer, const struct scene *scene,
                                    const struct mesh_face *face, struct vertex *vertices,
                                    int32 count)
{
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];

    for (int32 i = 0; i < count; i++, corner++) {
        const struct mesh_point *p = &placed->points[corner->point];

        vertices[i].x = p->x;
        vertices[i].y = p->y;
    }
    vertices = mesh_clip(scene->scratch->cut, vertices, &count, scene->header->near_plane);
    if (count < 3)
        return POLYGON_EMPTY;
    project(vertices, count, scene->header);
    return draw_polygon(renderer, vertices, count, placed->material);
}

static enum polygon_result draw_face(struct renderer *renderer, const struct scene *scene,
                                     const struct mesh_face *face)
{
    struct vertex *vertices = scene->scratch->face;
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];
    int32 count = (int32)face->face->corners;
    struct vertex *v = vertices;
    uint32 outside = 0;

    for (int32 i = count; i > 0; i--, corner++, v++) {
        const struct mesh_point *p = &placed->points[corner->point];
        const struct mesh_attributes *attributes = &placed->attributes[corner->normal];

        outside |= p->outside;
        v->x = p->screen_x;
        v->y = p->screen_y;
        v->w = p->w;
        v->s = corner->s;
        v->t = corner->t;
        v->shade = 0;
        if (placed->flags & MESH_ENVIRONMENT) {
            v->s = attributes->s;
            v->t = attributes->t;
        }
        if (placed->flags & MESH_LIT)
            v->shade = attributes->shade;
    }
    if (outside)
        return draw_cut(renderer, scene, face, vertices, count);
    return draw_polygon(renderer, vertices, count, placed->material);
}

/* Draws faces in batches, as many as routines for triangles can; returns the first that is left. */
static const struct mesh_face *draw_batches(struct mesh_batch *batch,
                                            const struct renderer *renderer,
                                            const struct mesh_face *face,
                                            const struct mesh_face *end)
{
    const struct material *const material = face->placed->material;
    const enum span_kind kind = triangle_batch_kind(renderer, material);
    triangle_drawer *routine;
    const int32 is_shaded = material->mapper == MAPPER_GOURAUD;
    struct triangle_plan plan;
    struct triangle_lines lines;
    struct gather_plan gather;

    if (kind == SPAN_KINDS || material->light || (is_shaded && !(face->placed->flags & MESH_LIT)))
        return face;
    routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
    plan.list = batch->list;
    gather.end = end;
    gather.vertices = batch->vertices;
    gather.full = &batch->list[BATCH_TRIANGLES - (TRIANGLE_CORNERS_MAX - 2)];
    gather.material = material;
    gather.flags = face->placed->flags;
    gather.values = material->mapper == MAPPER_FLAT ? GATHER_NONE
                  : is_shaded ? GATHER_SHADES : GATHER_TEXELS;
    gather.scale = material->map && material->map->scale != 65536 ? material->map->scale : 0;
    do {
        gather.from = face;
        gather.list = batch->list;
        face = mesh_gather(&gather);
        plan.end = gather.list;
        routine(&plan);
    } while (gather.list > gather.full && face < end);
    return face;
}

/* Sets s, t and shade of an instance's normals; there is at least one. */
static void make_attributes(struct mesh_attributes *to, const struct scene_normal *normals,
                            int32 count, const struct scene_instance *instance,
                            const struct scene_view *view)
{
    struct attribute_plan plan;

    plan.from = normals;
    plan.count = count;
    if (instance->flags & MESH_ENVIRONMENT) {
        plan.base = 128 << 16;
        plan.low = 0;
        plan.high = 256 << 16;
        plan.to = &to->s;
        plan.factors = &view->s_x;
        mesh_attributes(&plan);
        plan.to = &to->t;
        plan.factors = &view->t_x;
        mesh_attributes(&plan);
    }
    if (instance->flags & MESH_LIT) {
        plan.base = plan.low = instance->dark;
        plan.high = instance->bright;
        plan.to = &to->shade;
        plan.factors = &view->light_x;
        mesh_attributes(&plan);
    }
}

/* Snaps an instance's points for routines for triangles. */
static void snap(const struct renderer *renderer, struct mesh_point *points, int32 count)
{
    struct triangle_range range;
    struct snap_plan plan;

    triangle_range_set(&range, renderer->frame);
    plan.right = range.right;
    plan.bottom = range.bottom;
    plan.points = points;
    plan.count = count;
    mesh_snap(&plan);
}

/* Transforms the points and normals of an instance and collects the faces that may be visible;
   returns their number. */
static int32 place(const struct renderer *renderer, const struct scene *scene,
                   const struct scene_instance *instance, const struct scene_view *view,
                   struct mesh_work *at)
{
    const struct scene_header *header = scene->header;
    const struct scene_mesh *mesh = &scene->meshes[instance->mesh];
    struct mesh_placed *placed = at->placed;
    struct transform_plan transform;
    struct faces_plan faces;

    placed->mesh = mesh;
    placed->corners = &scene->corners[mesh->corner];
    placed->material = &scene->drawn[instance->material];
    placed->points = at->points;
    placed->attributes = at->attributes;
    placed->flags = instance->flags;
    transform.from = &scene->points[mesh->point];
    transform.count = (int32)mesh->points;
    transform.view = view;
    transform.to = at->points;
    transform.near_plane = header->near_plane;
    transform.guard = header->guard;
    transform.middle_x = header->width << 15;
    transform.middle_y = header->height << 15;
    mesh_transform(&transform);
    if (triangle_batch_kind(renderer, placed->material) != SPAN_KINDS)
        snap(renderer, at->points, transform.count);
    if (instance->flags)
        make_attributes(at->attributes, &scene->normals[mesh->normal], (int32)mesh->normals,
                        instance, view);
    at->placed++;
    at->points += mesh->points;
    at->attributes += mesh->normals;
    faces.from = &scene->faces[mesh->face];
    faces.count = (int32)mesh->faces;
    faces.placed = placed;
    faces.view = view;
    faces.to = at->faces;
    return mesh_faces(&faces);
}

enum polygon_result mesh_draw(struct renderer *renderer, const struct scene *scene, int32 number,
                              uint32 first, uint32 end)
{
    enum polygon_result refused = POLYGON_DRAWN;
    struct mesh_work at = scene->work;
    const struct mesh_face *face, *last, *next;
    int32 count = 0;

    for (; first < end; first++) {
        const struct scene_instance *instance = &scene->instances[first];
        uint32 age = (uint32)number - instance->first_frame;

        if (age < instance->views) {
            int32 more = place(renderer, scene, instance, &scene->views[instance->view + age], &at);

            count += more;
            at.faces += more;
        }
    }
    face = mesh_sort(scene->work.faces, scene->work.sorted, count, scene->scratch->buckets);
    for (last = face + count; face < last; face = next) {
        enum polygon_result result;

        next = draw_batches(&scene->scratch->batch, renderer, face, last);
        if (next > face)
            continue;
        next = face + 1;
        result = draw_face(renderer, scene, face);
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
    }
    return refused;
}
