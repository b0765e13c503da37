/* Sutherland and Hodgman's clipping, before the divide: on a border w - near, w + x, w - x, w + y
   or w - y is 0. With coordinates below 16,384 these depths fit 32 bits, and the difference between
   an edge's ends fits 32 bits without sign. */
#include "mesh/mesh.h"

/* Returns the borders, enum mesh_outside, that a vertex is outside of. */
static uint32 outside_of(const struct vertex *v, int32 count, fix16 near_plane)
{
    uint32 outside = 0;

    for (; count > 0; count--, v++) {
        const fix16 x = v->x, y = v->y, w = v->w;

        if (w < near_plane)
            outside |= MESH_NEAR;
        if (w + x < 0)
            outside |= MESH_LEFT;
        if (w - x < 0)
            outside |= MESH_RIGHT;
        if (w + y < 0)
            outside |= MESH_ABOVE;
        if (w - y < 0)
            outside |= MESH_BELOW;
    }
    return outside;
}

/* Sets how far inside a border vertices are. */
static void set_depths(int32 *to, const struct vertex *v, int32 count, uint32 border, fix16 near_plane)
{
    const fix16 *value = border & (MESH_LEFT | MESH_RIGHT) ? &v->x : &v->y;

    if (border == MESH_NEAR)
        for (; count > 0; count--, v++)
            *to++ = v->w - near_plane;
    else if (border & (MESH_LEFT | MESH_ABOVE))
        for (; count > 0; count--, v++, value += VERTEX_FIELDS)
            *to++ = v->w + *value;
    else
        for (; count > 0; count--, v++, value += VERTEX_FIELDS)
            *to++ = v->w - *value;
}

/* Makes the vertex where a border cuts an edge, whose inner and outer end are so far inside. It is always calculated
   from the inner end, so that both directions of an edge give the same vertex. */
static void cut(struct cut_plan *plan, int32 inner, int32 outer, uint32 border, fix16 near_plane)
{
    struct vertex *const to = plan->to;

    plan->part = inner;
    plan->whole = (uint32)inner - (uint32)outer;
    mesh_cut(plan);
    if (border == MESH_NEAR)
        to->w = near_plane;
    else if (border == MESH_LEFT)
        to->x = -to->w;
    else if (border == MESH_RIGHT)
        to->x = to->w;
    else if (border == MESH_ABOVE)
        to->y = -to->w;
    else
        to->y = to->w;
}

static int32 clip_border(struct vertex *to, const struct vertex *from, int32 count,
                         uint32 border, fix16 near_plane)
{
    const struct vertex *const first = to, *const most = to + (POLYGON_VERTICES_MAX - 2);
    const struct vertex *last = &from[count - 1];
    int32 depths[POLYGON_VERTICES_MAX], *depth = depths, last_depth;
    struct cut_plan plan;

    set_depths(depths, from, count, border, near_plane);
    last_depth = depths[count - 1];
    for (; count > 0; count--, from++) {
        const int32 here = *depth++;

        if (to > most)
            return 0;
        plan.to = to;
        if (here >= 0) {
            if (last_depth < 0 && here > 0) {
                plan.inside = from;
                plan.outside = last;
                cut(&plan, here, last_depth, border, near_plane);
                to++;
            }
            *to++ = *from;
        } else if (last_depth > 0) {
            plan.inside = last;
            plan.outside = from;
            cut(&plan, last_depth, here, border, near_plane);
            to++;
        }
        last = from;
        last_depth = here;
    }
    return (int32)(to - first);
}

struct vertex *mesh_clip(struct vertex *room, struct vertex *vertices, int32 *count,
                         fix16 near_plane, uint32 outside)
{
    struct vertex *other = room + POLYGON_VERTICES_MAX;

    for (uint32 border = MESH_NEAR; outside && *count > 0; border <<= 1) {
        struct vertex *to = room;

        if (!(outside & border))
            continue;
        *count = clip_border(to, vertices, *count, border, near_plane);
        vertices = to;
        room = other;
        other = to;
        outside &= 0 - border - border;
        if (border < MESH_BELOW)        /* rounding may move new vertices outside of another border */
            outside = outside_of(vertices, *count, near_plane) & (0 - border - border);
    }
    return vertices;
}
