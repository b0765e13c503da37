/* Draws a tree each pixel once, from its nearest node on: what is beyond the frame's borders, and what is behind when no
   pixel is left, is neither transformed nor looked at. */
#include "coverage/coverage.h"
#include "coverage/touched.h"
#include "frames/draw_bodies.h"
#include "frames/draw_meshes.h"

/* A tree in a frame. */
struct near_tree {
    struct near_walk walk;      /* first: is_hidden casts */
    const struct scene *scene;
    const struct renderer *renderer;
    struct mesh_point *points;
    struct mesh_attributes *attributes; /* memory that is left */
    struct mesh_face *faces;
    struct mesh_placed *placed; /* of the first instance; mesh is 0 if the frame lacks it, points until it is needed */
    uint32 first, count;        /* its number; instances */
    const struct near_slot *slots;
    struct near_face face;
    struct mesh_face *seen;
};

/* Sets mesh, view and points of the instances that are in the frame; returns 0 if their views differ. */
static int32 set_instances(struct near_tree *tree, int32 number, uint32 end)
{
    const struct scene *const scene = tree->scene;
    const struct scene_instance *instance = &scene->instances[tree->first];
    const struct scene_instance *const last = &scene->instances[end];
    const int32 root = instance->tree;
    struct mesh_placed *placed = tree->placed;

    tree->walk.view = 0;
    for (; instance < last && instance->tree == root; instance++, placed++) {
        const uint32 age = (uint32)number - instance->first_frame;

        placed->mesh = 0;
        if (age >= instance->views)
            continue;
        placed->mesh = &scene->meshes[instance->mesh];
        placed->view = &scene->views[instance->view + age];
        placed->points = 0;
        if (!scene->near->is_still && tree->walk.view && !near_same_place(tree->walk.view, placed->view))
            return 0;
        tree->walk.view = placed->view;
    }
    tree->count = (uint32)(placed - tree->placed);
    return 1;
}

/* Returns 1 if no pixel is left in the rectangle of a box. */
static int32 is_hidden(const struct near_walk *walk, const struct mesh_box *box)
{
    const struct near_tree *tree = (const struct near_tree *)walk;
    struct rectangle pixels;

    return near_rectangle(walk, box, &pixels)
        && coverage_hides_box(tree->scene->coverage, tree->renderer->frame, &pixels);
}

/* Returns the slots of a tree: those of the trees before it come first. */
static const struct near_slot *slots_of(const struct scene *scene, int32 root)
{
    const struct near_slot *slots = scene->near->slots;

    for (const struct scene_node *node = scene->nodes; node != &scene->nodes[root]; node++) {
        node += node->front + node->back;       /* the tree's last */
        slots += node->slot + node->slots;
    }
    return slots;
}

static void begin_walk(struct near_tree *tree, int32 root)
{
    const struct scene *const scene = tree->scene;
    const struct scene_header *const header = scene->header;
    struct near_walk *const walk = &tree->walk;

    walk->frame.width = header->width;
    walk->frame.height = header->height;
    walk->frame.guard = header->guard;
    walk->frame.near_plane = header->near_plane;
    walk->node = &scene->nodes[root];
    walk->last = walk->steps;
    walk->nodes = scene->nodes;
    walk->boxes = scene->near->boxes;
    walk->is_hidden = is_hidden;
    near_set_borders(walk, walk->boxes[root].shift);
    near_set_view(&tree->face, &walk->frame, walk->view);
    near_set_edges(&tree->face, EDGE_ERROR);    /* edges are exact: scene_wrong_once */
    tree->face.stamp = ++scene->near->stamp;
    tree->face.gaps = scene->coverage->rows;
    tree->face.points = tree->points;
    tree->face.from = tree->slots->points;
}

/* Sets the rest of the instance in a slot, whose first face is to be drawn. */
static void begin_instance(struct near_tree *tree, struct mesh_placed *placed, const struct near_slot *slot)
{
    const struct scene *const scene = tree->scene;
    const struct scene_instance *const instance = &scene->instances[slot->instance];

    placed->corners = slot->corners - slot->face->corner;
    placed->material = &scene->drawn[instance->material];
    placed->view16 = 0;
    placed->places = 0;
    placed->attributes = 0;
    placed->flags = instance->flags;
    if (instance->flags & MESH_FOG)
        mesh_set_fog(&placed->fog, instance);
    placed->points = tree->points;
    if (instance->flags & (MESH_ENVIRONMENT | MESH_LIT)) {
        placed->attributes = tree->attributes;
        mesh_make_attributes(tree->attributes, &scene->normals[placed->mesh->normal], (int32)placed->mesh->normals,
                             instance, placed->view);
        tree->attributes += placed->mesh->normals;
    }
}

/* Draws what is visible of the face in a slot, some of whose points are outside of borders. */
static enum polygon_result draw_slot(struct renderer *renderer, struct near_tree *tree, const struct near_slot *slot,
                                     uint32 outside)
{
    const struct scene *const scene = tree->scene;
    const uint32 instance = slot->instance - tree->first;
    struct mesh_placed *const placed = &tree->placed[instance];
    struct mesh_face *const face = tree->faces;
    enum polygon_result result;

    if (instance >= tree->count || !placed->mesh)
        return POLYGON_EMPTY;
    if (!placed->points)
        begin_instance(tree, placed, slot);
    face->face = slot->face;
    face->placed = placed;
    scene->coverage->shown = 0;
    result = mesh_draw_face(renderer, scene, face, outside & MESH_NEAR ? coverage_draw : coverage_draw_met);
    if (scene->coverage->shown || result > POLYGON_EMPTY) {
        face->next = tree->seen;
        tree->seen = face;
        tree->faces++;
    }
    return result;
}

enum near_result mesh_draw_near(struct renderer *renderer, const struct scene *scene, int32 number,
                                uint32 first, uint32 end, const struct mesh_work *room,
                                enum polygon_result *refused, struct mesh_face **seen)
{
    struct coverage *const coverage = scene->coverage;
    const int32 root = scene->instances[first].tree;
    const struct scene_node *node;
    struct near_tree tree;
    struct bodies bodies;

    tree.scene = scene;
    tree.renderer = renderer;
    tree.placed = room->placed;
    tree.points = room->points;
    tree.attributes = room->attributes;
    tree.faces = room->faces;
    tree.walk.steps = room->steps;
    tree.first = first;
    tree.slots = slots_of(scene, root);
    tree.seen = 0;
    *seen = 0;
    if (!set_instances(&tree, number, end))
        return NEAR_OTHERWISE;
    if (!tree.walk.view)
        return NEAR_DRAWN;
    if (scene->touched)
        touched_fill(scene->touched);
    begin_walk(&tree, root);
    bodies_begin(&bodies, scene, &tree.walk, number);
    coverage_begin(coverage, renderer->frame);
    renderer->coverage = coverage;
    while (coverage->open && !coverage->overflow && (node = mesh_near(&tree.walk)) != 0) {
        int32 found;

        tree.face.slots = &tree.slots[node->slot];
        tree.face.slot = &tree.face.slots[node->slots];
        while (coverage->open && !coverage->overflow && (found = mesh_near_face(&tree.face)) != NEAR_NONE) {
            enum polygon_result result;

            if (bodies.in_frame)
                bodies_meet(&bodies, &tree.face, found & MESH_NEAR);
            result = draw_slot(renderer, &tree, tree.face.slot, (uint32)found);
            if (bodies.in_frame && coverage->shown)
                tree.seen->order = bodies.marks;
            if (bodies.met)
                bodies_pass(&bodies);

            if (result > POLYGON_EMPTY)
                *refused = result;
        }
    }
    *seen = tree.seen;
    if (scene->near->bodies)
        scene->near->bodies->marks = coverage->overflow ? 0 : bodies_end(&bodies);
    return coverage->overflow ? NEAR_OVERFLOW : NEAR_DRAWN;
}
