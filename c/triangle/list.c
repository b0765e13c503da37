#include "triangle/list.h"

#include "triangle/polygon.h"

enum { LIST_TRIANGLES = 24 };   /* drawn together, on the stack */

/* Vertices on the screen as the material's edges take them. */
static fix16 placed(fix16 at, const struct material *material)
{
    return material->edges == EDGES_SNAPPED ? (at + SNAPPED_HALF) & ~SNAPPED_MASK
         : material->edges == EDGES_INTEGER ? at & ~0xffff : at;
}

/* Returns non-zero if a triangle's corners are anticlockwise, or it has no area. */
static int32 is_turned(const struct vertex *corner, const struct material *material)
{
    const fix16 x = placed(corner->x, material), y = placed(corner->y, material);
    const fix16 x1 = placed(corner[1].x, material) - x, y1 = placed(corner[1].y, material) - y;
    const fix16 x2 = placed(corner[2].x, material) - x, y2 = placed(corner[2].y, material) - y;
    const int32 one = mul_shift(x1, y2, 31), other = mul_shift(x2, y1, 31);

    if (one != other)
        return one < other;
    return (((uint32)x1 * (uint32)y2) & 0x7fffffff) <= (((uint32)x2 * (uint32)y1) & 0x7fffffff);
}

/* Draws a triangle of the list by polygon_draw. */
static enum polygon_result draw_one(struct renderer *renderer, const struct triangle_list *list,
                                    int32 number, const struct material *material)
{
    const uint16 *index = &list->indices[3 * number];
    struct vertex corners[3];
    struct polygon polygon;

    for (int32 i = 0; i < 3; i++)
        corners[i] = list->vertices[index[i]];
    if (list->cull && is_turned(corners, material))
        return POLYGON_EMPTY;
    polygon_set(&polygon, corners, 3, PLANAR_ALL);
    return polygon_draw(renderer, &polygon, material);
}

/* Makes count triangles from the list's indices. */
static void point(struct triangle *to, const struct triangle_list *list, int32 number, int32 count)
{
    const uint16 *index = &list->indices[3 * number];

    for (; count > 0; count--, to++) {
        to->a = &list->room[*index++];
        to->b = &list->room[*index++];
        to->c = &list->room[*index++];
    }
}

enum polygon_result triangles_draw(struct renderer *renderer, const struct triangle_list *list,
                                   const struct material *material)
{
    const enum span_kind kind = triangle_batch_kind(renderer, material);
    triangle_drawer *routine = 0;
    enum polygon_result result, refused = POLYGON_DRAWN;
    struct triangle room[LIST_TRIANGLES];
    struct triangle_plan plan;
    struct triangle_lines lines;
    struct vertices_plan vertices;
    struct triangle_range range;

    if (kind != SPAN_KINDS) {
        triangle_range_set(&range, renderer->frame);
        vertices.right = range.right;
        vertices.bottom = range.bottom;
        vertices.scale = triangle_scale(material);
        vertices.values = triangle_values(material->mapper);
        vertices.count = list->vertex_count;
        vertices.from = list->vertices;
        vertices.to = list->room;
        triangle_vertices(&vertices);
        routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
        plan.cull = list->cull;
    }
    for (int32 first = 0, some = 1; first < list->count; first += some) {
        const struct triangle *left = room;

        if (routine) {
            some = list->count - first;
            some = some < LIST_TRIANGLES ? some : LIST_TRIANGLES;
            point(room, list, first, some);
        }
        for (plan.end = &room[some]; left < plan.end; left++) {
            plan.list = left;
            if (routine && (left = routine(&plan)) == plan.end)
                break;
            result = draw_one(renderer, list, first + (int32)(left - room), material);
            if (result > POLYGON_EMPTY)
                refused = result;
        }
    }
    return refused;
}
