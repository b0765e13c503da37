/* Tables of trees that are walked from the nearest face on. */
#include "math/math.h"
#include "mesh/near.h"
#include "scene/load.h"
#include "system/system.h"

enum {
    BOX_MOST = 32766,           /* a coordinate of a box, rounded down */
    CHAINS = 256
};

static uint32 nodes_of(const struct scene_node *root)
{
    return 1 + root->front + root->back;
}

static uint32 slots_of(const struct scene_node *root)
{
    const struct scene_node *const last = root + root->front + root->back;

    return last->slot + last->slots;
}

static void include(struct mesh_box *box, const struct mesh_box *other)
{
    int16 *low = &box->low_x, *high = &box->high_x;
    const int16 *other_low = &other->low_x, *other_high = &other->high_x;

    for (int32 k = 0; k < 3; k++, low++, high++, other_low++, other_high++) {
        if (*other_low < *low)
            *low = *other_low;
        if (*other_high > *high)
            *high = *other_high;
    }
}

/* Takes the corners of a face into a box. */
static void include_face(struct mesh_box *box, const struct near_slot *slot)
{
    const struct scene_corner *corner = slot->corners;

    for (uint32 i = slot->face->corners; i; i--, corner++) {
        const struct scene_point *p = &slot->points[corner->point];
        struct mesh_box at;

        at.low_x = (int16)(p->x >> box->shift);
        at.low_y = (int16)(p->y >> box->shift);
        at.low_z = (int16)(p->z >> box->shift);
        at.high_x = (int16)(at.low_x + 1);
        at.high_y = (int16)(at.low_y + 1);
        at.high_z = (int16)(at.low_z + 1);
        include(box, &at);
    }
}

/* Returns the slots of a node and of those of its front and back, whose boxes are made; at most 65,535. */
static uint16 count_of(const struct scene_node *node, const struct mesh_box *box)
{
    uint32 count = node->slots;

    if (node->front)
        count += box[1].slots;
    if (node->back)
        count += box[1 + node->front].slots;
    return (uint16)(count > 0xffff ? 0xffff : count);
}

/* Makes the boxes of a tree, those of a node's front and back before its own. */
static void make_boxes(struct mesh_box *boxes, const struct scene_node *root, const struct near_slot *slots,
                       int32 shift)
{
    for (uint32 i = nodes_of(root); i > 0; i--) {
        const struct scene_node *node = &root[i - 1];
        struct mesh_box *box = &boxes[i - 1];

        box->low_x = box->low_y = box->low_z = BOX_MOST;
        box->high_x = box->high_y = box->high_z = -BOX_MOST;
        box->shift = (int16)shift;
        box->slots = count_of(node, box);
        for (uint32 k = 0; k < node->slots; k++)
            if (slots[node->slot + k].face)
                include_face(box, &slots[node->slot + k]);
        if (node->front)
            include(box, box + 1);
        if (node->back)
            include(box, box + 1 + node->front);
    }
}

static uint32 larger(uint32 most, int32 coordinate)
{
    const uint32 size = fix_magnitude(coordinate);

    return size > most ? size : most;
}

/* Places of a tree's points while each is looked for among those before it. */
struct places {
    struct scene_point *points;
    uint32 count;
    struct mesh_point *scratch; /* outside: the next in a chain; spare: a mesh point's number here */
    uint32 chains[CHAINS];      /* the last point of each, plus 1 */
};

/* Returns the number of a place among the points, which has it from now on. */
static uint32 number_of(struct places *places, const struct scene_point *p)
{
    const uint32 mixed = (uint32)p->x * 5 + (uint32)p->y * 3 + (uint32)p->z;
    uint32 *const chain = &places->chains[(mixed ^ mixed >> 8 ^ mixed >> 16) % CHAINS];
    struct scene_point *to = &places->points[places->count];

    for (uint32 i = *chain; i; i = places->scratch[i - 1].outside) {
        const struct scene_point *other = &places->points[i - 1];

        if (other->x == p->x && other->y == p->y && other->z == p->z)
            return i - 1;
    }
    to->x = p->x;
    to->y = p->y;
    to->z = p->z;
    places->scratch[places->count].outside = *chain;
    *chain = ++places->count;
    return places->count - 1;
}

/* Copies the corners of an instance's mesh, with numbers of the tree's points. */
static void copy_corners(struct scene_corner *to, const struct scene *scene, const struct scene_mesh *mesh,
                         struct places *places)
{
    const struct scene_corner *from = &scene->corners[mesh->corner];

    for (uint32 i = 0; i < mesh->points; i++)
        places->scratch[i].spare = number_of(places, &scene->points[mesh->point + i]);
    for (uint32 i = mesh->corners; i; i--, to++, from++) {
        to->point = (uint16)places->scratch[from->point].spare;
        to->normal = from->normal;
        to->s = from->s;
        to->t = from->t;
    }
}

/* Puts the faces of a tree's instances into its slots, and sets *corners and *points behind its own; returns the
   greatest magnitude of a coordinate. */
static uint32 fill_slots(struct near_slot *slots, const struct scene *scene, int32 tree, struct scene_corner **corners,
                         struct scene_point **points)
{
    const struct scene_instance *o = scene->instances;
    struct places places;
    uint32 most = 0;

    places.points = *points;
    places.count = 0;
    places.scratch = scene->work.points;
    for (int32 i = 0; i < CHAINS; i++)
        places.chains[i] = 0;
    for (uint32 i = 0; i < scene->header->instances; i++, o++) {
        const struct scene_mesh *mesh = &scene->meshes[o->mesh];
        const struct scene_slot *slot = &scene->slots[o->slot];

        if (o->tree != tree)
            continue;
        copy_corners(*corners, scene, mesh, &places);
        for (uint32 k = 0; k < mesh->faces; k++, slot++) {
            struct near_slot *const to = &slots[slot->slot];

            to->face = &scene->faces[mesh->face + k];
            to->instance = i;
            to->corners = &(*corners)[to->face->corner];
        }
        *corners += mesh->corners;
    }
    for (uint32 i = slots_of(&scene->nodes[tree]); i; i--)
        slots[i - 1].points = *points;
    for (; places.count; places.count--, ++*points)
        most = larger(larger(larger(most, (*points)->x), (*points)->y), (*points)->z);
    return most;
}

/* Returns 1 if all instances of each tree have the same frames and views. */
static int32 are_still(const struct scene *scene)
{
    const struct scene_instance *o = scene->instances, *first = o;

    for (uint32 i = scene->header->instances; i; i--, o++) {
        if (o->tree != first->tree || o->before != first->before)
            first = o;
        if (o->tree < 0 || o == first)
            continue;
        if (o->first_frame != first->first_frame || o->views != first->views)
            return 0;
        for (uint32 k = 0; k < o->views; k++)
            if (!near_same_place(&scene->views[o->view + k], &scene->views[first->view + k]))
                return 0;
    }
    return 1;
}

/* Makes the tables; slots, corners, points: how many all trees have. Returns 0 if memory is short. */
static int32 make_tables(struct scene_near *near, uint32 nodes, uint32 slots, uint32 corners, uint32 points)
{
    return mem_alloc(&near->boxes, (int32)(nodes * sizeof *near->boxes), MEMORY_ANY)
        && mem_alloc(&near->slots, (int32)(slots * sizeof *near->slots), MEMORY_ANY)
        && mem_alloc(&near->corners, (int32)(corners * sizeof *near->corners), MEMORY_ANY)
        && mem_alloc(&near->points, (int32)(points * sizeof *near->points), MEMORY_ANY);
}

/* Makes the bodies of a scene; returns 0 if memory is short. */
static int32 make_bodies(struct scene_near *near, const struct scene *scene)
{
    const struct scene_instance *o = scene->instances;
    struct body *body;
    uint32 count = 0;

    near->bodies = 0;
    for (uint32 i = 0; i < scene->header->instances; i++)
        if (o[i].tree == TREE_Z)
            count = i + 1;
    if (!count)
        return 1;
    if (!mem_alloc(&near->bodies, sizeof *near->bodies, MEMORY_ANY)
        || !mem_alloc(&near->bodies->each, (int32)(count * sizeof *near->bodies->each), MEMORY_ANY))
        return 0;
    near->bodies->first = near->bodies->end = 0;
    for (body = near->bodies->each; count; count--, o++, body++)
        body_measure(body, &scene->points[scene->meshes[o->mesh].point], scene->meshes[o->mesh].points);
    return 1;
}

int32 scene_make_near(struct scene *scene)
{
    const uint32 nodes = scene->header->nodes;
    const struct scene_instance *o = scene->instances;
    struct scene_corner *corner;
    struct scene_point *point;
    struct near_slot *slot;
    uint32 slots = 0, corners = 0, points = 0;

    scene->near = 0;
    if (!scene->is_once || !nodes)
        return 1;
    for (uint32 root = 0; root < nodes; root += nodes_of(&scene->nodes[root]))
        slots += slots_of(&scene->nodes[root]);
    for (uint32 i = 0; i < scene->header->instances; i++, o++)
        if (o->tree >= 0) {
            if (i && o[-1].tree == o->tree && o[-1].before != o->before)
                return 1;       /* its points are not all in memory at once */
            corners += scene->meshes[o->mesh].corners;
            points += scene->meshes[o->mesh].points;
        }
    if (!mem_alloc(&scene->near, sizeof *scene->near, MEMORY_ANY)
        || !make_tables(scene->near, nodes, slots, corners, points) || !make_bodies(scene->near, scene))
        return 0;
    scene->near->is_still = are_still(scene);
    corner = scene->near->corners;
    point = scene->near->points;
    slot = scene->near->slots;
    for (uint32 root = 0; root < nodes; root += nodes_of(&scene->nodes[root])) {
        const uint32 most = fill_slots(slot, scene, (int32)root, &corner, &point);
        int32 shift = 0;

        while (most >> shift > BOX_MOST)
            shift++;
        make_boxes(&scene->near->boxes[root], &scene->nodes[root], slot, shift);
        slot += slots_of(&scene->nodes[root]);
    }
    return 1;
}
