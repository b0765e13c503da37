/* Tables of trees that are walked from the nearest face on. */
#include "math/math.h"
#include "mesh/near.h"
#include "scene/scene.h"
#include "system/system.h"

enum { BOX_MOST = 32766 };      /* a coordinate of a box, rounded down */

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
static void include_face(struct mesh_box *box, const struct scene *scene, const struct near_slot *slot)
{
    const struct scene_mesh *mesh = &scene->meshes[scene->instances[slot->instance].mesh];
    const struct scene_corner *corner = &scene->corners[mesh->corner + slot->face->corner];

    for (uint32 i = slot->face->corners; i; i--, corner++) {
        const struct scene_point *p = &scene->points[mesh->point + corner->point];
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
static void make_boxes(struct mesh_box *boxes, const struct scene *scene, const struct scene_node *root,
                       const struct near_slot *slots, int32 shift)
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
                include_face(box, scene, &slots[node->slot + k]);
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

/* Puts the faces of a tree's instances into its slots; returns the greatest magnitude of a coordinate. */
static uint32 fill_slots(struct near_slot *slots, const struct scene *scene, int32 tree)
{
    const struct scene_instance *o = scene->instances;
    uint32 most = 0;

    for (uint32 i = 0; i < scene->header->instances; i++, o++) {
        const struct scene_mesh *mesh = &scene->meshes[o->mesh];
        const struct scene_point *p = &scene->points[mesh->point];
        const struct scene_slot *slot = &scene->slots[o->slot];

        if (o->tree != tree)
            continue;
        for (uint32 k = 0; k < mesh->faces; k++, slot++) {
            slots[slot->slot].face = &scene->faces[mesh->face + k];
            slots[slot->slot].instance = i;
        }
        for (uint32 k = mesh->points; k; k--, p++)
            most = larger(larger(larger(most, p->x), p->y), p->z);
    }
    return most;
}

int32 scene_make_near(struct scene *scene)
{
    const uint32 nodes = scene->header->nodes;
    struct scene_near *near;
    uint32 slots = 0;

    scene->near = 0;
    if (!scene->is_once || !nodes)
        return 1;
    for (uint32 root = 0; root < nodes; root += nodes_of(&scene->nodes[root]))
        slots += slots_of(&scene->nodes[root]);
    if (!mem_alloc(&scene->near, sizeof *near, MEMORY_ANY))
        return 0;
    near = scene->near;
    if (!mem_alloc(&near->boxes, (int32)(nodes * sizeof *near->boxes), MEMORY_ANY)
        || !mem_alloc(&near->slots, (int32)(slots * sizeof *near->slots), MEMORY_ANY))
        return 0;
    slots = 0;
    for (uint32 root = 0; root < nodes; root += nodes_of(&scene->nodes[root])) {
        const uint32 most = fill_slots(&near->slots[slots], scene, (int32)root);
        int32 shift = 0;

        while (most >> shift > BOX_MOST)
            shift++;
        make_boxes(&near->boxes[root], scene, &scene->nodes[root], &near->slots[slots], shift);
        slots += slots_of(&scene->nodes[root]);
    }
    return 1;
}
