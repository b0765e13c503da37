/* Sutherland and Hodgman's clipping, before the divide: on a border w - near, w + x, w - x, w + y
   or w - y is 0. With coordinates below 16,384 these depths fit 32 bits, and the difference between
   an edge's ends fits 32 bits without sign. */
#include "mesh/mesh.h"

/* Returns how far inside a border a vertex is. */
static int32 depth(const struct vertex *v, uint32 border, fix16 near_plane)
{
    switch (border) {
    case MESH_NEAR:
        return v->w - near_plane;
    case MESH_LEFT:
        return v->w + v->x;
    case MESH_RIGHT:
        return v->w - v->x;
    case MESH_ABOVE:
        return v->w + v->y;
    default:
        return v->w - v->y;
    }
}

/* Makes the vertex where a border cuts an edge. It is always calculated from the inner end, so that
   both directions of an edge give the same vertex. */
static void cut(struct vertex *to, const struct vertex *inside, const struct vertex *outside,
                uint32 border, fix16 near_plane)
{
    struct cut_plan plan;

    plan.to = to;
    plan.inside = inside;
    plan.outside = outside;
    plan.part = depth(inside, border, near_plane);
    plan.whole = (uint32)plan.part - (uint32)depth(outside, border, near_plane);
    mesh_cut(&plan);
    switch (border) {
    case MESH_NEAR:
        to->w = near_plane;
        break;
    case MESH_LEFT:
        to->x = -to->w;
        break;
    case MESH_RIGHT:
        to->x = to->w;
        break;
    case MESH_ABOVE:
        to->y = -to->w;
        break;
    default:
        to->y = to->w;
        break;
    }
}

static int32 clip_border(struct vertex *to, const struct vertex *from, int32 count,
                         uint32 border, fix16 near_plane)
{
    const struct vertex *last = &from[count - 1];
    int32 last_depth = depth(last, border, near_plane), made = 0;

    for (; count > 0; count--, from++) {
        int32 here = depth(from, border, near_plane);

        if (made > POLYGON_VERTICES_MAX - 2)
            return 0;
        if (here >= 0) {
            if (last_depth < 0 && here > 0)
                cut(&to[made++], from, last, border, near_plane);
            to[made++] = *from;
        } else if (last_depth > 0) {
            cut(&to[made++], last, from, border, near_plane);
        }
        last = from;
        last_depth = here;
    }
    return made;
}

static int32 all_inside(const struct vertex *v, int32 count, uint32 border, fix16 near_plane)
{
    for (; count > 0; count--, v++)
        if (depth(v, border, near_plane) < 0)
            return 0;
    return 1;
}

struct vertex *mesh_clip(struct vertex *room, struct vertex *vertices, int32 *count,
                         fix16 near_plane)
{
    struct vertex *other = room + POLYGON_VERTICES_MAX;

    for (uint32 border = MESH_NEAR; border <= MESH_BELOW && *count > 0; border <<= 1) {
        struct vertex *to = room;

        if (all_inside(vertices, *count, border, near_plane))
            continue;
        *count = clip_border(to, vertices, *count, border, near_plane);
        vertices = to;
        room = other;
        other = to;
    }
    return vertices;
}
