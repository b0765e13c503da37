#include "triangle/polygon.h"

#include "limits.h"
#include "polygon/counts.h"
#include "polygon/scratch.h"
#include "polygon/shading.h"

/* Returns non-zero if u or v may be the same along lines: the triangles of the polygon have a level edge,
   are not small, and a level edge has equal ends. Triangles have the same picture in either way of
   drawing only if they are not small. */
static int32 triangle_may_be_still(const struct snapped_vertex *v, int32 count)
{
    const struct snapped_vertex *last = &v[count - 1];
    const int32 y = v->y;
    int32 other = y, still = 0;

    for (; count > 0; count--, last = v++) {
        if (v->y != y) {
            if (other != y && v->y != other)
                return 0;
            other = v->y;
        }
        still |= v->y == last->y && (v->u == last->u || v->v == last->v);
    }
    return still && (other - y > SMALL_HEIGHT || y - other > SMALL_HEIGHT);
}

static int32 triangle_is_equal(const struct vertex *v, int32 count, int32 lowest)
{
    const fix16 first = v->shade >> lowest;

    while (--count > 0)
        if ((++v)->shade >> lowest != first)
            return 0;
    return 1;
}

/* Returns a cheaper kind that the vertices allow; sets *colour if that is flat. */
static enum span_kind triangle_by_vertices(enum span_kind kind, uint32 *colour,
                                           const struct renderer *renderer,
                                           const struct polygon *polygon,
                                           const struct material *material)
{
    const struct vertex *const v = polygon->vertices;
    const int32 level = v->shade >> LEVEL_BITS;

    if (kind == SPAN_TRIANGLES_GOURAUD && RULE_IS_ON(renderer, EQUAL_SHADES)
        && triangle_is_equal(v, polygon->count, 16)) {
        *colour = (uint32)v->shade >> 16;
        return SPAN_TRIANGLES_FLAT;
    }
    if (kind == SPAN_LIT_GOURAUD && RULE_IS_ON(renderer, EQUAL_LEVELS)
        && triangle_is_equal(v, polygon->count, LEVEL_BITS))
        kind = SPAN_LIT_WRAP;   /* u is as without wraps of v */
    if (kind != SPAN_LIT && kind != SPAN_LIT_WRAP)
        return kind;
    if (level == 0 && material->light->dark && RULE_IS_ON(renderer, NO_LIGHT)) {
        *colour = *material->light->texels;
        return SPAN_TRIANGLES_FLAT;
    }
    if (level == LIGHT_LEVELS - 1 && material->light->full && RULE_IS_ON(renderer, FULL_LIGHT))
        return kind == SPAN_LIT ? SPAN_AFFINE_ADDX : SPAN_AFFINE_ADDX_WRAP;
    return kind;
}

/* MAPPER_ARBITRARY: returns non-zero if no pixel of a triangle leaves the map. */
static int32 triangle_stays_in_map(const struct snapped_vertex *v, const struct map *map)
{
    const int32 dx1 = v[1].x - v->x, dy1 = v[1].y - v->y, dx2 = v[2].x - v->x, dy2 = v[2].y - v->y;
    const int32 area = dx1 * dy2 - dx2 * dy1;
    const int32 low = (SNAPPED_RAISED + BELOW_MAP) << 4, over = (SNAPPED_RAISED - ABOVE_MAP) * 16;
    const int32 u_high = (map->width << 20) + over, v_high = (map->height << 20) + over;
    int32 most = dy1 > dy2 ? dy1 : dy2, least = dy1 < dy2 ? dy1 : dy2;

    most = most < 0 ? 0 : most;
    least = least > 0 ? 0 : least;
    for (int32 i = 0; i < 3; i++, v++)
        if (v->u < low || v->u > u_high || v->v < low || v->v > v_high)
            return 0;
    return (area < 0 ? -area : area) >= SLIVER_MAP * (most - least);
}

/* Converts the vertices of a polygon of up to TRIANGLE_CORNERS_MAX corners to those of the plan. Returns
   the kind that draws it and sets *colour; SPAN_KINDS if no routine for triangles can. */
static enum span_kind triangle_convert(struct vertices_plan *to, enum span_kind kind,
                                       uint32 *colour, const struct renderer *renderer,
                                       const struct polygon *polygon,
                                       const struct material *material)
{
    const int32 count = polygon->count;

    to->count = count;
    to->from = polygon->vertices;
    if (!triangle_vertices(to))
        return SPAN_KINDS;
    *colour = material->colour;
    if (kind == SPAN_TRIANGLES_AFFINE) {
        if (material->mapper == MAPPER_ARBITRARY
            && (count > 3 || !triangle_stays_in_map(to->to, material->map)))
            return SPAN_KINDS;
        return triangle_may_be_still(to->to, count) ? SPAN_AFFINE_ADDX : kind;
    }
    return material->mapper == MAPPER_FLAT
         ? kind : triangle_by_vertices(kind, colour, renderer, polygon, material);
}

/* Makes the triangles of a polygon, all with its first corner; returns the place behind them. */
static struct triangle *triangle_fan(struct triangle *to, const struct snapped_vertex *vertices,
                                     int32 count)
{
    const struct snapped_vertex *v = &vertices[1];

    for (; count > 2; count--, to++) {
        to->a = vertices;
        to->b = v++;
        to->c = v;
    }
    return to;
}

enum span_kind triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                                const struct material *material)
{
    enum span_kind kind = triangle_kind(renderer->frame, material);
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX];
    struct triangle list[TRIANGLE_CORNERS_MAX - 2];
    struct vertices_plan made;
    struct triangle_plan plan;
    struct triangle_lines lines;
    triangle_drawer *routine;
    uint32 colour;

    if (kind == SPAN_KINDS || polygon->count > TRIANGLE_CORNERS_MAX)
        return SPAN_KINDS;
    vertices_plan_set(&made, renderer->frame, material);
    made.to = vertices;
    kind = triangle_convert(&made, kind, &colour, renderer, polygon, material);
    if (kind == SPAN_KINDS)
        return SPAN_KINDS;
    routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
    plan.colour = colour * 0x01010101;
    plan.list = list;
    plan.end = triangle_fan(list, vertices, polygon->count);
    if (routine == triangles_spans) {
        routine(&plan);
        return plan.lowered;
    }
    if (!renderer->counts || !renderer->only_counts)
        routine(&plan);
    return kind;
}

enum { RUN_VERTICES = 128 };    /* drawn together */

/* Use of the scratch room by a run. */
struct run_room {
    uint32 shades[FRAME_SIDE_MAX];              /* of triangle_plan_set */
    struct snapped_vertex vertices[RUN_VERTICES];
    struct triangle list[RUN_VERTICES];
};

SCRATCH_FITS(struct run_room);

/* Draws the triangles from the plan's list up to `end`; returns the list. */
static struct triangle *triangle_flush(struct triangle_plan *plan, triangle_drawer *routine,
                                       struct run_room *room, const struct triangle *end)
{
    plan->list = room->list;
    plan->end = end;
    if (end != room->list)
        routine(plan);
    return room->list;
}

enum polygon_result triangle_run(struct renderer *renderer, const struct polygon *polygons,
                                 int32 count, const struct material *material,
                                 polygon_routine *other)
{
    const enum span_kind kind = triangle_kind(renderer->frame, material);
    struct run_room *const room = (struct run_room *)renderer->scratch->room;
    struct triangle *last = room->list;
    enum span_kind of_plan = SPAN_KINDS;
    uint32 colour = 0, colour_of_plan = 0;
    enum polygon_result refused = POLYGON_DRAWN;
    triangle_drawer *routine = 0;
    struct vertices_plan made;
    struct triangle_plan plan;
    struct triangle_lines lines;

    vertices_plan_set(&made, renderer->frame, material);
    made.to = room->vertices;
    for (; count > 0; count--, polygons++) {
        enum span_kind found = SPAN_KINDS;

        if (kind != SPAN_KINDS && (uint32)polygons->count - 3 <= TRIANGLE_CORNERS_MAX - 3)
            found = triangle_convert(&made, kind, &colour, renderer, polygons, material);
        if (found != of_plan || colour != colour_of_plan) {
            last = triangle_flush(&plan, routine, room, last);
            of_plan = found;
            colour_of_plan = colour;
            if (found != SPAN_KINDS) {
                routine = triangle_plan_set(&plan, found, &lines, renderer, material);
                plan.colour = colour * 0x01010101;
            }
        }
        if (found == SPAN_KINDS) {
            const enum polygon_result result = other(renderer, polygons, material);

            refused = result > POLYGON_EMPTY ? result : refused;
            continue;
        }
        last = triangle_fan(last, made.to, polygons->count);
        made.to += polygons->count;
        if (made.to > &room->vertices[RUN_VERTICES - TRIANGLE_CORNERS_MAX]) {
            last = triangle_flush(&plan, routine, room, last);
            made.to = room->vertices;
        }
    }
    triangle_flush(&plan, routine, room, last);
    return refused;
}
