/* Checks the meshes, instances, views and trees of a scene, so that drawing cannot leave its arrays and
   its numbers cannot exceed 32 bits. */
#include "scene/load.h"

enum limits {
    UNIT_14 = 1 << 14,
    UNIT_30 = 1 << 30,
    REACH = MESH_REACH << 16,
    AWAY = MESH_AWAY << 16
};

static int32 beyond(int32 value, int32 most)
{
    return value < -most || value > most;
}

/* Returns 1 if `count` entries from `first` on are inside a table of `table` entries. */
static int32 inside(uint32 first, uint32 count, uint32 table)
{
    return first <= table && count <= table - first;
}

static const char *wrong_table(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_point *p = scene->points;
    const struct scene_normal *n = scene->normals;
    const struct scene_view *v = scene->views;

    for (uint32 i = h->points; i; i--, p++)
        if (beyond(p->x, REACH) || beyond(p->y, REACH) || beyond(p->z, REACH))
            return "point";
    for (uint32 i = h->normals; i; i--, n++)
        if (beyond(n->x, UNIT_14) || beyond(n->y, UNIT_14) || beyond(n->z, UNIT_14))
            return "normal";
    for (uint32 i = h->views; i; i--, v++) {
        const int32 *factor = &v->xx;
        int32 k = 9;

        for (; k > 0; k--)
            if (beyond(*factor++, UNIT_30))
                return "view.xx to zz";
        if (beyond(v->x0, AWAY - 1) || beyond(v->y0, AWAY - 1) || beyond(v->z0, AWAY - 1))
            return "view.x0, y0 or z0";
    }
    return 0;
}

static const char *wrong_view16(const struct scene *scene)
{
    const struct scene_view16 *v = scene->views16;

    for (uint32 i = scene->header->views16; i; i--, v++) {
        const int16 *row = &v->wx;
        int32 k = 3;

        for (; k > 0; k--, row += (&v->xx - &v->wx))
            if (beyond(row[0], MESH_FACTOR16) || beyond(row[1], MESH_FACTOR16)
                || beyond(row[2], MESH_FACTOR16))
                return "view16.wx to yz";
        if ((uint32)v->divisor_shift > MESH_SHIFT16 || (uint32)v->depth_shift > MESH_SHIFT16
            || (uint32)v->seen_shift > MESH_SHIFT16)
            return "view16.divisor_shift, depth_shift or seen_shift";
    }
    return 0;
}

static const char *wrong_face(const struct scene *scene, const struct scene_mesh *mesh)
{
    const struct scene_face *face = &scene->faces[mesh->face];
    const struct scene_corner *corner = &scene->corners[mesh->corner];

    for (uint32 i = mesh->corners; i; i--, corner++) {
        if (corner->point >= mesh->points)
            return "corner.point";
        if (corner->normal >= mesh->normals)
            return "corner.normal";
    }
    for (uint32 i = mesh->faces; i; i--, face++) {
        if (face->corners < 3 || face->corners > MESH_CORNERS_MAX
            || !inside(face->corner, face->corners, mesh->corners))
            return "face.corners";
        if (beyond(face->x, UNIT_30) || beyond(face->y, UNIT_30) || beyond(face->z, UNIT_30))
            return "face.x, y or z";
    }
    return 0;
}

static const char *wrong_mesh(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_mesh *m = scene->meshes;

    for (uint32 i = h->meshes; i; i--, m++) {
        const char *wrong;

        if (m->points < 1 || m->points > MESH_COUNT_MAX
            || !inside(m->point, m->points, h->points))
            return "mesh.points";
        if (m->normals < 1 || m->normals > MESH_COUNT_MAX
            || !inside(m->normal, m->normals, h->normals))
            return "mesh.normals";
        if (!inside(m->corner, m->corners, h->corners))
            return "mesh.corners";
        if (m->faces < 1 || m->faces > MESH_COUNT_MAX || !inside(m->face, m->faces, h->faces))
            return "mesh.faces";
        wrong = wrong_face(scene, m);
        if (wrong)
            return wrong;
    }
    return 0;
}

/* Checks a material's requirements on the instance and its mesh. */
static const char *wrong_look(const struct scene *scene, const struct scene_instance *instance)
{
    const struct scene_material *m = &scene->materials[instance->material];
    const struct scene_mesh *mesh = &scene->meshes[instance->mesh];
    const struct scene_face *face = &scene->faces[mesh->face];
    const struct scene_corner *corner = &scene->corners[mesh->corner];

    if (instance->flags & (MESH_LIT | MESH_FOG)
        && (instance->dark < 0 || instance->bright < instance->dark
            || instance->bright >= 256 << 16))
        return "instance.dark or bright";
    if (m->mapper == MAPPER_GOURAUD && !(instance->flags & (MESH_LIT | MESH_FOG)))
        return "instance.flags";
    if (instance->flags & MESH_FOG) {
        if (instance->flags & MESH_LIT || (m->light == NO_TEXTURE && m->mapper != MAPPER_GOURAUD))
            return "instance.flags";
        if (instance->fog_near < 0 || instance->fog_far <= instance->fog_near || instance->fog_far > W_MAX)
            return "instance.fog_near or fog_far";
    }
    if (m->mapper != MAPPER_FLAT && m->gradients == GRADIENTS_POLYGON)
        for (uint32 i = mesh->faces; i; i--, face++)
            if (face->corners != 3)
                return "face.corners";
    if (m->mapper == MAPPER_ARBITRARY) {
        if (instance->flags & MESH_ENVIRONMENT)
            return "instance.flags";
        for (uint32 i = mesh->corners; i; i--, corner++)
            if (scene_wrong_texel(scene, m, corner->s, corner->t))
                return "corner.s or t";
    }
    return 0;
}

static const char *wrong_instance(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_instance *o = scene->instances;
    uint32 before = 0;

    if (h->instances && (h->near_plane < W_MIN || h->near_plane >= W_MAX))
        return "near_plane";
    if (h->instances && (h->guard < GUARD_MIN || h->guard > GUARD_MAX))
        return "guard";
    for (uint32 i = h->instances; i; i--, o++) {
        const char *wrong;

        if (o->mesh >= h->meshes)
            return "instance.mesh";
        if (o->material >= h->materials || scene->materials[o->material].primitive
            || scene_has_own(scene, &scene->materials[o->material]))
            return "instance.material";
        if (o->before < before || o->before > h->objects)
            return "instance.before";
        before = o->before;
        if (o->views < 1 || !inside(o->view, o->views, h->views))
            return "instance.views";
        if (o->view16 != NO_VIEW16 && !inside((uint32)o->view16, o->views, h->views16))
            return "instance.view16";
        if (o->first_frame >= (uint32)h->frames)
            return "instance.first_frame";
        if (o->flags >= MESH_FLAGS)
            return "instance.flags";
        wrong = wrong_look(scene, o);
        if (wrong)
            return wrong;
    }
    return 0;
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
        if (beyond(node->x, UNIT_30) || beyond(node->y, UNIT_30) || beyond(node->z, UNIT_30))
            return "node.x, y or z";
        if (node->slot != slot || node->slots > SCENE_COUNT_MAX - slot)
            return "node.slot or slots";
        slot += node->slots;
    }
    *slots = slot;
    return 0;
}

/* Returns 1 if the faces of an instance may be tested pixel by pixel. before: the instance before it, or 0. */
static int32 may_be_tested(const struct scene *scene, const struct scene_instance *o,
                           const struct scene_instance *before)
{
    const struct scene_material *m = &scene->materials[o->material];

    return EDGES_ARE_EXACT(m->edges) && m->mapper != MAPPER_N64
        && m->mapper != MAPPER_GLIDE && scene->header->format == PIXEL_CHUNKY
        && (!before || before->before != o->before || before->tree == TREE_Z);
}

/* Checks all trees: walking one ends and stays in its slots. */
static const char *wrong_trees(const struct scene *scene)
{
    const struct scene_header *h = scene->header;
    const struct scene_instance *o = scene->instances;
    int32 tree = NO_TREE;
    uint32 next = 0, slots = 0;

    for (uint32 i = h->instances; i; i--, o++) {
        const struct scene_slot *slot = &scene->slots[o->slot];

        if (o->tree == TREE_Z) {
            if (!may_be_tested(scene, o, i == h->instances ? 0 : o - 1))
                return "instance.tree";
            tree = NO_TREE;
            continue;
        }
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

const char *scene_wrong_mesh(const struct scene *scene)
{
    const char *wrong = wrong_table(scene);

    if (!wrong)
        wrong = wrong_view16(scene);
    if (!wrong)
        wrong = wrong_mesh(scene);
    if (!wrong)
        wrong = wrong_instance(scene);
    return wrong ? wrong : wrong_trees(scene);
}
