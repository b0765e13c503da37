/* Checks the trees of a scene, so that walking one ends and stays in its slots. */
#include "scene/scene.h"

enum { UNIT_30 = 1 << 30 };

static int32 beyond(int32 value)
{
    return value < -UNIT_30 || value > UNIT_30;
}

/* Returns the nodes of a tree or of a part of it; wraps round. */
static uint32 size_of(const struct scene_node *node)
{
    return 1 + node->front + node->back;
}

/* Returns 1 if the nodes of a part's front and back are as many as the nodes say that follow it. Where
   this is so of all nodes, each is part of exactly one other, which comes before it. */
static int32 is_whole(const struct scene_node *node)
{
    return (!node->front || size_of(node + 1) == node->front)
        && (!node->back || size_of(node + 1 + node->front) == node->back);
}

/* Checks the tree that begins at a node of which `left` follow, itself included; sets *slots to the
   number of its slots. */
static const char *wrong_tree(const struct scene_node *node, uint32 left, uint32 *slots)
{
    uint32 slot = 0;

    if (node->front >= left || node->back >= left || size_of(node) > left)
        return "node.front or back";
    for (left = size_of(node); left; left--, node++) {
        if (node->front >= left || node->back >= left || size_of(node) > left || !is_whole(node))
            return "node.front or back";
        if (beyond(node->x) || beyond(node->y) || beyond(node->z))
            return "node.x, y or z";
        if (node->slot != slot || node->slots > SCENE_COUNT_MAX - slot)
            return "node.slot or slots";
        slot += node->slots;
    }
    *slots = slot;
    return 0;
}

const char *scene_wrong_tree(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_instance *o = scene->instances;
    int32 tree = NO_TREE;
    uint32 next = 0, slots = 0;

    for (uint32 i = h->instances; i; i--, o++) {
        const struct scene_slot *slot = &scene->slots[o->slot];

        if (o->tree != NO_TREE && o->tree != tree) {
            const char *wrong;

            if ((uint32)o->tree != next || next >= h->nodes)
                return "instance.tree";
            wrong = wrong_tree(&scene->nodes[next], h->nodes - next, &slots);
            if (wrong)
                return wrong;
            next += size_of(&scene->nodes[next]);
        }
        tree = o->tree;
        if (tree == NO_TREE)
            continue;
        if (o->slot > h->slots || scene->meshes[o->mesh].faces > h->slots - o->slot)
            return "instance.slot";
        for (uint32 k = scene->meshes[o->mesh].faces; k; k--, slot++)
            if (slot->slot >= slots)
                return "slot.slot";
    }
    return next == h->nodes ? 0 : "nodes";
}
