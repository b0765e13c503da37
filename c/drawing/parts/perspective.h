/* What of perspective a program leaves out: parts.h includes it. */
#ifndef DRAWING_PARTS_PERSPECTIVE_H
#define DRAWING_PARTS_PERSPECTIVE_H

#include "drawing/deep.h"
#include "drawing/draw.h"
#include "perspective/cubic.h"
#include "perspective/far.h"
#include "perspective/perspective.h"
#include "perspective/tolerance.h"

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

#ifndef WITH_PERSPECTIVE
int32 perspective_polygon(struct setup *s)
{
    return 0;
}

enum polygon_result deep_run(struct deep *deep, struct renderer *renderer, const struct polygon *polygons,
                             const struct polygon *end, const struct material *material)
{
    return POLYGON_REFUSED;
}

enum polygon_result polygon_draw_deep(struct renderer *renderer, const struct polygon *polygon,
                                      const struct material *material)
{
    return polygon_draw_inside(renderer, polygon, material);
}

int32 deep_begin(struct deep *deep, struct renderer *renderer)
{
    return 0;
}

int32 deep_take(struct deep *deep, const struct material *material)
{
    return 0;
}

int32 deep_draw(struct deep *deep)
{
    return DEEP_CONSTANT;
}

int32 tolerance_is_flat(const struct setup *s)
{
    return 0;
}

int32 tolerance_is_coarser(struct setup *s)
{
    return 0;
}
#endif

#if defined(WITH_PERSPECTIVE) && !defined(WITH_RECIPROCALS)
far_routine *const far_spans[2][3][2] = {{{0, 0}, {0, 0}, {0, 0}}, {{0, 0}, {0, 0}, {0, 0}}};

const uint16 *reciprocals_make(uint16 *table)
{
    return 0;
}

void far_draw(const struct setup *s, const struct depth *depth, const struct far_way *way, struct far_line *lines)
{
}
#endif

#if defined(WITH_PERSPECTIVE) && !defined(WITH_CURVES)
int32 cubic_find(struct cubic_span *span, const struct setup *s, const struct depth *depth)
{
    return 0;
}

void cubic_draw(const struct setup *s, struct cubic_span *span, const struct far_line *lines)
{
}
#endif

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
