/* Turns instances into polygons. Every point is transformed to the camera and projected once, with
   16-bit operands where the file has factors for them and all points are on the screen.
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

/* Transforms points of an instance with 32-bit operands, from the first given on. */
static void transform_wide(const struct scene *scene, const struct mesh_placed *placed,
                           uint32 first, int32 count)
{
    const struct scene_header *header = scene->header;
    struct wide_plan plan;

    plan.from = &scene->points[placed->mesh->point + first];
    plan.count = count;
    plan.view = placed->view;
    plan.to = &placed->points[first];
    plan.near_plane = header->near_plane;
    plan.guard = header->guard;
    plan.middle_x = header->width << 15;
    plan.middle_y = header->height << 15;
    mesh_transform_wide(&plan);
}

static enum polygon_result draw_cut(struct renderer *renderer, const struct scene *scene,
                                    const struct mesh_face *face, struct vertex *vertices,
                                    int32 count)
{
    const struct mesh_placed *placed = face->placed;
    const struct scene_corner *corner = &placed->corners[face->face->corner];

    for (int32 i = 0; i < count; i++, corner++) {
        const struct mesh_point *p = &placed->points[corner->point];

        if (placed->view16)
            transform_wide(scene, placed, corner->point, 1);
        vertices[i].x = p->x;
        vertices[i].y = p->y;
        vertices[i].w = p->w;
    }
    vertices = mesh_clip(scene->scratch->cut, vertices, &count, scene->header->near_plane);
    if (count < 3)
        return POLYGON_EMPTY;
    project(vertices, count, scene->header);
    return draw_polygon(renderer, vertices, count, placed->material);
}

/* Sets a vertex's x, y and w; returns the borders that it is outside of. */
static uint32 set_place(struct vertex *v, const struct mesh_placed *placed, uint32 point)
{
    const struct mesh_place *place = &placed->places[point];

    if (!placed->view16 || place->place < 0) {
        const struct mesh_point *p = &placed->points[point];

        v->x = p->screen_x;
        v->y = p->screen_y;
        v->w = p->w;
        return p->outside;
    }
    v->x = ((place->place >> 16) - SNAPPED_ONE) << (16 - SNAPPED_BITS);
    v->y = ((int16)place->place - (SNAPPED_ONE - 1)) << (16 - SNAPPED_BITS);
    v->w = place->depth << placed->view16->depth_shift;
    return 0;
}

/* Sets a vertex's s, t and shade. */
static void set_values(struct vertex *v, const struct mesh_placed *placed,
                       const struct scene_corner *corner)
{
    const struct mesh_attributes *attributes = &placed->attributes[corner->normal];

    v->s = corner->s;
    v->t = corner->t;
    v->shade = 0;
    if (placed->flags & MESH_LINKED) {
        const struct mesh_place *place = &placed->places[corner->point];

        v->s = v->shade = (place->u >> 4) - SNAPPED_RAISED;
        v->t = (place->v >> 4) - SNAPPED_RAISED;
        return;
    }
    if (placed->flags & MESH_ENVIRONMENT) {
        v->s = attributes->s;
        v->t = attributes->t;
    }
    if (placed->flags & MESH_LIT)
        v->shade = attributes->shade;
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
        outside |= set_place(v, placed, corner->point);
        set_values(v, placed, corner);
    }
    if (outside)
        return draw_cut(renderer, scene, face, vertices, count);
    return draw_polygon(renderer, vertices, count, placed->material);
}

/* Draws faces of a list in batches, as many as routines for triangles can; returns the first that is
   left. */
static const struct mesh_face *draw_batches(struct mesh_batch *batch,
                                            const struct renderer *renderer,
                                            const struct mesh_face *face)
{
    const struct material *const material = face->placed->material;
    const enum span_kind kind = triangle_batch_kind(renderer, material);
    triangle_drawer *routine;
    const int32 is_shaded = material->mapper == MAPPER_GOURAUD;
    const int32 is_linked = (face->placed->flags & MESH_LINKED) != 0;
    struct triangle_plan plan;
    struct triangle_lines lines;
    struct gather_plan gather;

    if (kind == SPAN_KINDS
        || ((is_shaded || material->light) && !(face->placed->flags & MESH_LIT)))
        return face;
    routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
    gather.vertices = batch->vertices;
    gather.list = batch->list;
    gather.full = &batch->list[BATCH_TRIANGLES - (TRIANGLE_CORNERS_MAX - 2)];
    gather.material = material;
    gather.flags = face->placed->flags;
    gather.values = material->mapper == MAPPER_FLAT ? GATHER_NONE
                  : is_shaded ? GATHER_SHADES
                  : material->light ? GATHER_LIT : GATHER_TEXELS;
    gather.scale = material->map && material->map->scale != 65536 ? material->map->scale : 0;
    do {
        gather.from = face;
        face = is_linked ? mesh_link(&gather) : mesh_gather(&gather);
        plan.list = gather.list;
        plan.end = gather.last;
        routine(&plan);
    } while (gather.last > gather.full && face);
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

/* Returns MESH_LINKED if an instance's triangles may have its places as vertices, else 0. */
static uint32 linked(const struct renderer *renderer, const struct scene *scene,
                     const struct mesh_placed *placed)
{
    const struct material *material = placed->material;
    const uint32 flags = placed->flags;

    if (triangle_batch_kind(renderer, material) == SPAN_KINDS)
        return 0;
    if (material->mapper == MAPPER_FLAT)
        return MESH_LINKED;
    if (!scene->smooth[placed->mesh - scene->meshes])
        return 0;
    return (material->mapper == MAPPER_GOURAUD && flags & MESH_LIT)
        || (material->mapper == MAPPER_AFFINE && flags & MESH_ENVIRONMENT
            && material->map->scale == 65536) ? MESH_LINKED : 0;
}

/* Sets u and v of a linked instance's places. */
static void make_values(struct mesh_place *to, const struct scene_normal *normals, const uint8 *marks,
                        const struct mesh_placed *placed, const struct scene_instance *instance,
                        const struct scene_view *view)
{
    struct values_plan plan;

    plan.from = normals;
    plan.marks = marks;
    plan.to = to;
    if (placed->material->mapper == MAPPER_AFFINE) {
        plan.factors = &view->s_x;
        mesh_mirror(&plan);
    } else if (placed->material->mapper == MAPPER_GOURAUD) {
        plan.factors = &view->light_x;
        plan.low = instance->dark;
        plan.high = instance->bright;
        mesh_shade(&plan);
    }
}

/* Sets the marks of count points to 0 or MARKED. */
static void mark_all(uint8 *marks, int32 count, uint8 mark)
{
    uint32 *four = (uint32 *)marks;

    for (int32 left = count; left >= 0; left -= 4)
        *four++ = mark * 0x01010101u;
    marks[count] = MARKS_END;
}

/* Transforms the marked points of an instance with 16-bit operands, those off the screen with 32-bit
   ones too; returns 0 if one is behind the eye. */
static int32 place_points16(const struct renderer *renderer, const struct scene *scene,
                            const struct mesh_placed *placed, const uint8 *marks,
                            struct mesh_place *to)
{
    const int32 count = (int32)placed->mesh->points;
    struct transform_plan plan;
    struct triangle_range range;
    int32 off;

    triangle_range_set(&range, renderer->frame);
    plan.from = &scene->points16[placed->mesh->point];
    plan.marks = marks;
    plan.view = placed->view16;
    plan.to = to;
    plan.right = range.right;
    plan.bottom = range.bottom;
    off = mesh_transform(&plan);
    for (int32 i = 0; off > 0 && i < count; i++)
        if (marks[i] && to[i].place < 0)
            transform_wide(scene, placed, (uint32)i, 1);
    return off >= 0;
}

/* Returns non-zero if an instance's points are tried with 16-bit operands. */
static int32 has_view16(const struct mesh_placed *placed)
{
    return placed->view16 && placed->view16->is_used && placed->material->edges == EDGES_SNAPPED
        && !placed->material->perspective;
}

/* Transforms the points of an instance, and snaps them for routines for triangles. */
static void place_points(const struct renderer *renderer, const struct scene *scene,
                         const struct mesh_placed *placed, struct mesh_place *to)
{
    struct snap_plan snap;
    struct triangle_range range;

    snap.count = (int32)placed->mesh->points;
    transform_wide(scene, placed, 0, snap.count);
    if (triangle_batch_kind(renderer, placed->material) == SPAN_KINDS)
        return;
    triangle_range_set(&range, renderer->frame);
    snap.right = range.right;
    snap.bottom = range.bottom;
    snap.points = placed->points;
    snap.to = to;
    mesh_snap(&snap);
}

/* Transforms the points and normals of an instance and collects the faces that may be visible;
   returns their number. age: frames since its first one. */
static int32 place(const struct renderer *renderer, const struct scene *scene,
                   const struct scene_instance *instance, uint32 age, struct mesh_work *at)
{
    const struct scene_mesh *mesh = &scene->meshes[instance->mesh];
    const struct scene_view *view = &scene->views[instance->view + age];
    struct mesh_placed *placed = at->placed;
    struct faces_plan faces;
    struct orders_plan orders;
    int32 count = 0;

    placed->mesh = mesh;
    placed->corners = &scene->corners[mesh->corner];
    placed->material = &scene->drawn[instance->material];
    placed->points = at->points;
    placed->places = at->places;
    placed->view = view;
    placed->view16 = instance->view16 == NO_VIEW16
                   ? 0 : &scene->views16[(uint32)instance->view16 + age];
    placed->attributes = at->attributes;
    placed->flags = instance->flags;
    placed->flags |= linked(renderer, scene, placed);
    faces.from = &scene->faces[mesh->face];
    faces.count = (int32)mesh->faces;
    faces.placed = placed;
    faces.to = at->faces;
    faces.marks = at->marks;
    if (has_view16(placed)) {
        mark_all(at->marks, (int32)mesh->points, 0);
        count = mesh_faces(&faces);
        if (!place_points16(renderer, scene, placed, at->marks, at->places))
            placed->view16 = 0;
    } else
        placed->view16 = 0;
    if (!placed->view16) {
        mark_all(at->marks, (int32)mesh->points, MARKED);
        place_points(renderer, scene, placed, at->places);
        count = mesh_faces_wide(&faces);
    }
    if (placed->flags & MESH_LINKED)
        make_values(at->places, &scene->normals[mesh->normal], at->marks, placed, instance, view);
    else if (instance->flags)
        make_attributes(at->attributes, &scene->normals[mesh->normal], (int32)mesh->normals,
                        instance, view);
    if (count && (placed->view16 || placed->flags & MESH_LINKED)) {
        orders.faces = at->faces;
        orders.count = count;
        orders.placed = placed;
        orders.depth_shift = placed->view16 ? placed->view16->depth_shift : 0;
        mesh_orders(&orders);
    }
    at->placed++;
    at->points += mesh->points;
    at->places += mesh->points;
    at->attributes += mesh->normals;
    return count;
}

enum polygon_result mesh_draw(struct renderer *renderer, const struct scene *scene, int32 number,
                              uint32 first, uint32 end)
{
    enum polygon_result refused = POLYGON_DRAWN;
    struct mesh_work at = scene->work;
    const struct mesh_face *face;
    int32 count = 0;

    for (; first < end; first++) {
        const struct scene_instance *instance = &scene->instances[first];
        uint32 age = (uint32)number - instance->first_frame;

        if (age < instance->views) {
            const int32 more = place(renderer, scene, instance, age, &at);

            count += more;
            at.faces += more;
        }
    }
    face = mesh_sort(scene->work.faces, count, scene->scratch->buckets);
    while (face) {
        const struct mesh_face *const left = draw_batches(&scene->scratch->batch, renderer, face);
        enum polygon_result result;

        if (left != face) {
            face = left;
            continue;
        }
        result = draw_face(renderer, scene, face);
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
        face = face->next;
    }
    return refused;
}
