#include "drawing/draw.h"
#include "drawing/lower.h"
#include "polygon/counts.h"
#include "polygon/setup.h"
#include "triangle/triangles.h"

enum polygon_result polygon_draw_beyond(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    struct setup s;             /* what lower_to_nothing reads */

    s.off = renderer->off;
    s.applied = 0;
    s.frame = renderer->frame;
    s.material = material;
    s.given = polygon->vertices;
    s.count = polygon->count;
    if (!is_polygon(polygon) || !lower_to_nothing(&s))
        return polygon_draw_inside(renderer, polygon, material);
    if (renderer->counts)
        renderer->counts[material->number].rules[RULE_OUTSIDE]++;
    return POLYGON_EMPTY;
}

/* Draws a polygon by routines for triangles, if they can, or else by its own outline. */
static inline enum polygon_result draw_inside(struct renderer *renderer,
                                              const struct polygon *polygon,
                                              const struct material *material)
{
    if (material->edges == EDGES_SNAPPED && renderer->triangles && is_polygon(polygon)) {
        const enum span_kind kind = renderer->triangles->draw(renderer, polygon, material);

        if (kind != SPAN_KINDS) {
            if (renderer->counts)
                polygon_count_snapped(renderer, polygon, material, kind);
            return POLYGON_DRAWN;
        }
    }
    return polygon_draw_whole(renderer, polygon, material);
}

enum polygon_result polygon_draw_inside(struct renderer *renderer, const struct polygon *polygon,
                                        const struct material *material)
{
    return draw_inside(renderer, polygon, material);
}

enum polygon_result polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                 const struct material *material)
{
    if (begins_outside(renderer, polygon))
        return polygon_draw_beyond(renderer, polygon, material);
    if (material->edges == EDGES_SNAPPED)
        return draw_inside(renderer, polygon, material);
    if (material->perspective && (polygon->count == 3 || polygon->planar == PLANAR_ALL))
        return polygon_draw_deep(renderer, polygon, material);
    return polygon->count == 3 ? polygon_draw_three(renderer, polygon, material)
                               : draw_inside(renderer, polygon, material);
}
