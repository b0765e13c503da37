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

/* Returns the kind that draws a polygon whose vertices are converted; sets *colour if that is flat.
   SPAN_KINDS if no routine for triangles can draw it. */
static enum span_kind triangle_judged(enum span_kind kind, uint32 *colour,
                                      const struct snapped_vertex *vertices,
                                      const struct renderer *renderer,
                                      const struct polygon *polygon,
                                      const struct material *material)
{
    if (kind == SPAN_TRIANGLES_AFFINE) {
        if (material->mapper == MAPPER_ARBITRARY
            && (polygon->count > 3 || !triangle_stays_in_map(vertices, material->map)))
            return SPAN_KINDS;
        return triangle_may_be_still(vertices, polygon->count) ? SPAN_AFFINE_ADDX : kind;
    }
    return triangle_by_vertices(kind, colour, renderer, polygon, material);
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

/* Sets all but the polygons. */
static void fans_set(struct fans_plan *plan, struct snapped_vertex *vertices, struct triangle *list,
                     const struct frame *frame, const struct material *material)
{
    struct triangle_range range;

    triangle_range_set(&range, frame);
    plan->right = range.right;
    plan->bottom = range.bottom;
    plan->vertices = vertices;
    plan->scale = triangle_scale(material);
    plan->list = list;
    plan->values = triangle_values(material->mapper);
    plan->judged = plan->skips = 0;
    if (material->mapper == MAPPER_ARBITRARY)
        plan->judged = 1;
}

enum span_kind triangle_polygon(const struct renderer *renderer, const struct polygon *polygon,
                                const struct material *material)
{
    enum span_kind kind = triangle_kind(renderer->frame, material);
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX];
    struct triangle list[TRIANGLE_CORNERS_MAX - 2];
    uint32 colour = material->colour;
    struct fans_plan fans;
    struct triangle_plan plan;
    struct triangle_lines lines;
    triangle_drawer *routine;

    if (kind == SPAN_KINDS)
        return SPAN_KINDS;
    fans_set(&fans, vertices, list, renderer->frame, material);
    fans.from = polygon;
    fans.end = polygon + 1;
    if (triangle_fans(&fans) == polygon) {
        if (fans.is_odd)
            kind = triangle_judged(kind, &colour, vertices, renderer, polygon, material);
        if (!fans.is_odd || kind == SPAN_KINDS)
            return SPAN_KINDS;
        fans.last = triangle_fan(list, vertices, polygon->count);
    }
    routine = triangle_plan_set(&plan, kind, &lines, renderer, material);
    if (colour != material->colour)
        plan.colour = colour * 0x01010101;
    plan.list = list;
    plan.end = fans.last;
    if (routine == triangles_spans) {
        routine(&plan);
        return plan.lowered;
    }
    if (!renderer->counts || !renderer->only_counts)
        routine(&plan);
    return kind;
}

enum { BATCH_POLYGONS = 32 };

/* Use of the scratch room by a run. */
struct run_room {
    uint32 shades[FRAME_SIDE_MAX];              /* of triangle_plan_set */
    struct snapped_vertex vertices[TRIANGLE_CORNERS_MAX * BATCH_POLYGONS];
    struct triangle list[(TRIANGLE_CORNERS_MAX - 2) * BATCH_POLYGONS];
};

SCRATCH_FITS(struct run_room);

/* A run being drawn. */
struct triangle_run {
    struct fans_plan fans;
    struct triangle_plan plan;
    struct triangle_lines lines;
    triangle_drawer *routine;
    struct run_room *room;
    enum span_kind kind;        /* of the plan */
    uint32 colour;              /* the same */
};

/* Draws the triangles that were made. */
static void run_flush(struct triangle_run *run)
{
    run->plan.list = run->room->list;
    run->plan.end = run->fans.list;
    run->fans.list = run->room->list;
    if (run->plan.end != run->plan.list)
        run->routine(&run->plan);
}

static void run_set(struct triangle_run *run, enum span_kind kind, uint32 colour,
                    const struct renderer *renderer, const struct material *material)
{
    run->kind = kind;
    run->colour = colour;
    run->routine = triangle_plan_set(&run->plan, kind, &run->lines, renderer, material);
    run->plan.colour = colour * 0x01010101;
}

/* Draws a polygon that triangle_fans did not take. */
static enum polygon_result run_odd(struct triangle_run *run, enum span_kind kind,
                                   struct renderer *renderer, const struct polygon *polygon,
                                   const struct material *material, polygon_routine *other)
{
    struct fans_plan *const fans = &run->fans;
    uint32 colour = material->colour;

    kind = fans->is_odd ? triangle_judged(kind, &colour, fans->vertices, renderer, polygon, material)
                        : SPAN_KINDS;
    if (kind == SPAN_KINDS) {
        run_flush(run);
        return other(renderer, polygon, material);
    }
    if (kind != run->kind || colour != run->colour) {
        run_flush(run);
        run_set(run, kind, colour, renderer, material);
    }
    fans->list = triangle_fan(fans->list, fans->vertices, polygon->count);
    fans->vertices += polygon->count;
    return POLYGON_DRAWN;
}

/* Draws polygons of a material for which there is no routine for triangles. */
static enum polygon_result run_others(struct renderer *renderer, const struct polygon *polygons,
                                      int32 count, const struct material *material,
                                      polygon_routine *other)
{
    enum polygon_result result, refused = POLYGON_DRAWN;

    for (; count > 0; count--, polygons++) {
        result = other(renderer, polygons, material);
        refused = result > POLYGON_EMPTY ? result : refused;
    }
    return refused;
}

enum polygon_result triangle_run(struct renderer *renderer, const struct polygon *polygons,
                                 int32 count, const struct material *material,
                                 polygon_routine *other)
{
    const enum span_kind kind = triangle_kind(renderer->frame, material);
    const struct polygon *const end = polygons + count;
    enum polygon_result result, refused = POLYGON_DRAWN;
    struct triangle_run run;

    if (kind == SPAN_KINDS)
        return run_others(renderer, polygons, count, material, other);
    run.room = (struct run_room *)renderer->scratch->room;
    fans_set(&run.fans, run.room->vertices, run.room->list, renderer->frame, material);
    run.fans.skips = RULE_IS_ON(renderer, OUTSIDE)
                  && (!material->map || material->map->scale <= 65536);
    run.fans.beyond_x = (renderer->frame->width + 1) << 16;
    run.fans.beyond_y = renderer->frame->height << 16;
    run_set(&run, kind, material->colour, renderer, material);
    while (polygons < end) {
        const int32 room = (int32)(&run.room->vertices[TRIANGLE_CORNERS_MAX * BATCH_POLYGONS]
                                   - run.fans.vertices) / TRIANGLE_CORNERS_MAX;

        run.fans.from = polygons;
        run.fans.end = end - polygons < room ? end : polygons + room;
        run.fans.judged = run.kind != kind || material->mapper == MAPPER_ARBITRARY;
        polygons = triangle_fans(&run.fans);
        run.fans.list = run.fans.last;
        run.fans.vertices = run.fans.free;
        if (polygons == run.fans.end) {
            run_flush(&run);
            run.fans.vertices = run.room->vertices;
            continue;
        }
        result = run_odd(&run, kind, renderer, polygons, material, other);
        refused = result > POLYGON_EMPTY ? result : refused;
        polygons++;
    }
    run_flush(&run);
    return refused;
}
