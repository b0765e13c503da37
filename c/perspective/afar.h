/* How a polygon is drawn from the far ends of its lines. */
#ifndef PERSPECTIVE_AFAR_H
#define PERSPECTIVE_AFAR_H

#include "perspective/cubic.h"
#include "perspective/far.h"
#include "polygon/counts.h"
#include "polygon/kind.h"

union afar {
    struct far_way way;         /* by settings with straight pieces */
    struct cubic_span cubics;   /* by the others */
};

/* Returns 1 if the polygon's lines are drawn from their far ends: no planes of s and t are needed. */
static inline int32 afar_find(union afar *afar, const struct setup *s, const struct depth *depth)
{
    if (s->frame->pixel_bytes != 1)     /* tables of lines are for texels of one byte */
        return 0;
    return perspective_has_pieces(s->setting)
         ? s->renderer->reciprocals && far_find(&afar->way, s, depth)
         : cubic_find(&afar->cubics, s, depth);
}

/* Draws them. has_lines: they are in the scanline table; else edges are inside the frame. */
static inline void afar_draw(const struct setup *s, const struct depth *depth, union afar *afar,
                             int32 has_lines)
{
    const int32 has_pieces = perspective_has_pieces(s->setting);

    if (s->counts)
        count_lines(s, has_pieces ? SPAN_RECIPROCAL : SPAN_CUBIC);
    if (s->renderer->only_counts)
        return;
    if (has_pieces)
        far_draw(s, depth, &afar->way, has_lines);
    else
        cubic_draw(s, &afar->cubics, has_lines);
}

#endif
