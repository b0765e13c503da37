/* Polygons with perspective that are drawn by cubics from the far ends of their lines. */
#ifndef PERSPECTIVE_CUBIC_H
#define PERSPECTIVE_CUBIC_H

#include "perspective/far.h"
#include "span/cubic.h"

/* Finds all of a span but its lines and its map. Returns 0 if the polygon is not drawn this way. */
int32 cubic_find(struct cubic_span *span, const struct setup *s, const struct depth *depth);

/* Draws its lines. */
void cubic_draw(const struct setup *s, struct cubic_span *span, const struct far_line *lines);

/* Returns q's value or a step, 1.31, to the nearest. */
static inline int32 cubic_nearest(const struct number64 *from)
{
    return (int32)((from->hi << 1 | from->lo >> 31) + (from->lo >> 30 & 1));
}

/* Makes the lines of cubic_draw. has_lines: as far_make_lines'. */
static inline struct far_line *cubic_lines(const struct setup *s, int32 has_lines)
{
    const struct screen_plane *q = &s->perspective->q;

    return far_make_lines(s, (uint32)cubic_nearest(&q->at), cubic_nearest(&q->dx), cubic_nearest(&q->dy), has_lines);
}

#endif
