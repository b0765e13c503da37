/* Turns instances into polygons. Every point is transformed to the camera and projected once.
   Faces seen from the back or wholly outside one border are dropped; the others are drawn from
   the farthest to the nearest, clipped if they cross a border. */
#include "scene/draw_meshes.h"

#include "drawing/fan.h"
#include "math/math.h"
#include "polygon/shading.h"

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

/* Adds a face to the batch of its material. Returns 0 if routines for triangles cannot draw it; the
   batch may then have faces of another material, which are to be drawn before it. */
static int32 batch_face(struct triangle_batch *batch, const struct renderer *renderer,
                        const struct mesh_face *face)
{
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];
    const int32 count = (int32)face->face->corners;
    struct snapped_vertex *vertices, *to;
    fix16 shades[TRIANGLE_CORNERS_MAX], low = 0x7fffffff, high = 0;

    if (batch->material != placed->material) {
        triangle_flush(batch);
        triangle_begin(batch, renderer, placed->material);
    }
    if (!batch->routine || count > triangle_corners(batch->material))
        return 0;
    to = vertices = triangle_room(batch);
    for (int32 i = 0; i < count; i++, corner++, to++) {
        const struct mesh_point *p = &placed->points[corner->point];
        const struct mesh_attributes *attributes = &placed->attributes[corner->normal];
        const int32 mirrors = placed->flags & MESH_ENVIRONMENT;

        if (p->outside || !triangle_vertex(to, &batch->range, p->screen_x, p->screen_y,
                                           mirrors ? attributes->s : corner->s,
                                           mirrors ? attributes->t : corner->t))
            return 0;
        shades[i] = placed->flags & MESH_LIT ? attributes->shade : 0;
        low = shades[i] < low ? shades[i] : low;
        high = shades[i] > high ? shades[i] : high;
    }
    if (!triangle_is_low(vertices, count))
        return 0;
    if (batch->material->mapper == MAPPER_GOURAUD) {
        shade_limits(&low, &high);
        for (int32 i = 0; i < count; i++)
            vertices[i].u = triangle_value(shade_limited(shades[i], low, high));
    }
    triangle_add(batch, count);
    return 1;
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

/* Transforms the points and normals of an instance and collects the faces that may be visible;
   returns their number. */
static int32 place(const struct scene *scene, const struct scene_instance *instance,
                   const struct scene_view *view, struct mesh_work *at)
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
    struct triangle_batch *batch = &scene->scratch->batch;
    struct mesh_work at = scene->work;
    struct mesh_face *face;
    int32 count = 0;

    for (; first < end; first++) {
        const struct scene_instance *instance = &scene->instances[first];
        uint32 age = (uint32)number - instance->first_frame;

        if (age < instance->views) {
            int32 more = place(scene, instance, &scene->views[instance->view + age], &at);

            count += more;
            at.faces += more;
        }
    }
    face = mesh_sort(scene->work.faces, scene->work.sorted, count, scene->scratch->digits);
    batch->material = 0;
    batch->count = 0;
    for (; count > 0; count--, face++) {
        enum polygon_result result;

        if (batch_face(batch, renderer, face))
            continue;
        triangle_flush(batch);
        result = draw_face(renderer, scene, face);
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
    }
    triangle_flush(batch);
    return refused;
}
