/* Turns instances into faces to draw. Every point is transformed to the camera and projected once, with
   16-bit operands where the file has factors for them and all points are on the screen.
   Faces seen from the back or wholly outside one border are dropped; the others are put in order: by
   their tree, or from the farthest to the nearest. */
#include "frames/draw_meshes.h"

#include "frames/draw_touched.h"
#include "triangle/polygon.h"

void mesh_place_wide(const struct scene *scene, const struct mesh_placed *placed, uint32 first,
                     int32 count)
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

void mesh_make_texels(struct mesh_attributes *to, const struct scene_normal *normals, int32 count,
                      const struct scene_view *view)
{
    struct attribute_plan plan;

    plan.from = normals;
    plan.count = count;
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

void mesh_make_attributes(struct mesh_attributes *to, const struct scene_normal *normals,
                          int32 count, const struct scene_instance *instance,
                          const struct scene_view *view)
{
    struct attribute_plan plan;

    if (instance->flags & MESH_ENVIRONMENT)
        mesh_make_texels(to, normals, count, view);
    if (instance->flags & MESH_LIT) {
        plan.from = normals;
        plan.count = count;
        plan.base = plan.low = instance->dark;
        plan.high = instance->bright;
        plan.to = &to->shade;
        plan.factors = &view->light_x;
        mesh_attributes(&plan);
    }
}

/* Returns the bits that s and t are shifted by to texels of a map whose scale is a power of two up to 1; -1 for others. */
static int32 map_shift(const struct map *map)
{
    int32 shift = 0;

    while (map->scale << shift < 65536)
        shift++;
    return map->scale << shift == 65536 ? shift : -1;
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
            && map_shift(material->map) >= 0) ? MESH_LINKED : 0;
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
        plan.shift = map_shift(placed->material->map);
        mesh_mirror(&plan);
    } else if (placed->material->mapper == MAPPER_GOURAUD) {
        plan.factors = &view->light_x;
        plan.low = instance->dark;
        plan.high = instance->bright;
        mesh_shade(&plan);
    }
}

void mesh_set_fog(struct mesh_fog *to, const struct scene_instance *instance)
{
    to->near = instance->fog_near;
    to->far = instance->fog_far;
    to->dark = instance->dark;
    to->bright = instance->bright;
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
            mesh_place_wide(scene, placed, (uint32)i, 1);
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
    mesh_place_wide(scene, placed, 0, snap.count);
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
    placed->view16 = instance->view16 == NO_VIEW16 || scene->is_coarse
                   ? 0 : &scene->views16[(uint32)instance->view16 + age];
    placed->attributes = at->attributes;
    placed->flags = instance->flags;
    placed->flags |= linked(renderer, scene, placed);
    if (instance->flags & MESH_FOG)
        mesh_set_fog(&placed->fog, instance);
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
    else if (instance->flags & (MESH_ENVIRONMENT | MESH_LIT))
        mesh_make_attributes(at->attributes, &scene->normals[mesh->normal], (int32)mesh->normals,
                             instance, view);
    if (count && (placed->view16 || placed->flags & MESH_LINKED)) {
        orders.faces = at->faces;
        orders.count = count;
        orders.placed = placed;
        orders.depth_shift = placed->view16 ? placed->view16->depth_shift : 0;
        mesh_orders(&orders);
    }
    if (scene->touched && count)
        touched_instance(scene->touched, placed, at->marks);
    at->placed++;
    at->points += mesh->points;
    at->places += mesh->points;
    at->attributes += mesh->normals;
    return count;
}

/* Returns 1 if an instance has no visible pixel, as is known of some with TREE_Z while bodies are looked for. */
static int32 is_left_out(const struct scene *scene, const struct scene_instance *instance)
{
    const struct scene_bodies *const bodies = scene->near ? scene->near->bodies : 0;
    const uint32 number = (uint32)(instance - scene->instances);

    return bodies && number >= bodies->first && number < bodies->end && bodies->each[number].is_out;
}

/* Places the instances from *first to end (excluded) that are in the same tree, or in none, in memory from
   *room on, and sets *first and *room to the next; returns their faces in the order in which they are drawn. */
static struct mesh_face *place_all(const struct renderer *renderer, const struct scene *scene,
                                   int32 number, uint32 *first, uint32 end, struct mesh_work *room)
{
    struct mesh_work at = *room;
    struct mesh_face *const faces = at.faces;
    const struct scene_instance *instance = &scene->instances[*first];
    const struct scene_instance *const last = &scene->instances[end];
    const int32 tree = instance->tree;
    struct walk_plan walk;
    int32 count = 0;

    for (; instance < last && instance->tree == tree; instance++) {
        uint32 age = (uint32)number - instance->first_frame;

        if (age < instance->views && !is_left_out(scene, instance)) {
            const int32 more = place(renderer, scene, instance, age, &at);

            if (tree >= 0)
                mesh_fill(at.slots, &scene->slots[instance->slot],
                          &scene->faces[scene->meshes[instance->mesh].face], at.faces, more);
            count += more;
            at.faces += more;
            walk.view = &scene->views[instance->view + age];
        }
    }
    *first = (uint32)(instance - scene->instances);
    *room = at;
    if (tree < 0)
        return mesh_sort(faces, count, scene->scratch->buckets);
    if (!count)
        return 0;
    walk.root = &scene->nodes[tree];
    walk.slots = at.slots;
    walk.steps = at.steps;
    return mesh_walk(&walk);
}

/* Draws the instances from *first to end (excluded) that are in the same tree, or in none; sets *first to the next
   and *drawn to the faces in their order, those that are hidden may lack. */
static enum polygon_result draw_group(struct renderer *renderer, const struct scene *scene, int32 number,
                                      uint32 *first, uint32 end, const struct mesh_work *room,
                                      struct mesh_face **drawn)
{
    const int32 tree = scene->instances[*first].tree;
    enum near_result near = NEAR_OTHERWISE;
    enum polygon_result refused = POLYGON_DRAWN;
    struct mesh_work left = *room;

    if (scene->near && tree >= 0 && !renderer->only_counts)
        near = mesh_draw_near(renderer, scene, number, *first, end, room, &refused, drawn);
    if (near == NEAR_DRAWN) {
        while (*first < end && scene->instances[*first].tree == tree)
            ++*first;
        return refused;
    }
    *drawn = place_all(renderer, scene, number, first, end, &left);
    return scene->is_once && near != NEAR_OVERFLOW ? mesh_draw_once(renderer, scene, *drawn)
                                                   : mesh_draw_faces(renderer, scene, *drawn);
}

/* Begins to look for bodies among the instances with TREE_Z from *first on, which are placed once the tree that follows
   them is drawn: sets *first to that, and *room to memory behind theirs. Returns 0 if they are placed before. */
static int32 look_for_bodies(const struct renderer *renderer, const struct scene *scene, uint32 *first, uint32 end,
                             struct mesh_work *room)
{
    struct scene_bodies *const bodies = scene->near && !renderer->counts ? scene->near->bodies : 0;
    uint32 i = *first;

    while (i < end && scene->instances[i].tree == TREE_Z)
        i++;
    if (!bodies || i == end || scene->instances[i].tree < 0)
        return 0;
    bodies->first = *first;
    bodies->end = i;
    bodies->marks = 0;
    for (; *first < i; ++*first) {
        const struct scene_mesh *mesh = &scene->meshes[scene->instances[*first].mesh];

        bodies->each[*first].is_out = 0;
        room->placed++;
        room->points += mesh->points;
        room->places += mesh->points;
        room->attributes += mesh->normals;
        room->faces += mesh->faces;
    }
    return 1;
}

/* Places the instances with TREE_Z from *first on; returns their faces. */
static const struct mesh_face *place_tested(const struct renderer *renderer, const struct scene *scene, int32 number,
                                            uint32 *first, uint32 end, struct mesh_work *room)
{
    const struct mesh_face *const tested = place_all(renderer, scene, number, first, end, room);

    if (tested)
        mesh_depths_begin(scene, tested);
    return tested;
}

enum polygon_result mesh_draw(struct renderer *renderer, const struct scene *scene, int32 number,
                              uint32 first, uint32 end)
{
    enum polygon_result refused = POLYGON_DRAWN, result;
    struct mesh_work room = scene->work, tested_room = room;
    const struct mesh_face *tested = 0;
    uint32 first_tested = first;
    int32 groups = 0, is_looking = 0;

    if (scene->instances[first].tree == TREE_Z && !renderer->only_counts) {
        is_looking = look_for_bodies(renderer, scene, &first, end, &room);
        if (!is_looking)
            tested = place_tested(renderer, scene, number, &first, end, &room);
    }
    while (first < end) {
        const int32 is_first_tree = !groups++ && scene->instances[first].tree >= 0;
        struct mesh_face *face;
        uint32 marks = 0;

        result = draw_group(renderer, scene, number, &first, end, &room, &face);
        if (is_looking) {
            tested = place_tested(renderer, scene, number, &first_tested, end, &tested_room);
            scene->near->bodies->end = is_looking = 0;
            marks = scene->near->bodies->marks;
        }
        if (tested)
            mesh_depths_fill(renderer, scene, face, is_first_tree, marks);
        if (result != POLYGON_DRAWN)
            refused = result;
    }
    if (!tested)
        return refused;
    result = mesh_depths_draw(renderer, scene, tested);
    return result == POLYGON_DRAWN ? refused : result;
}
