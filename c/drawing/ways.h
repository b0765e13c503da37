/* Ways from a polygon's span plan to pixels that a program may leave out: drawing/parts.h. */
#ifndef DRAWING_WAYS_H
#define DRAWING_WAYS_H

#include "drawing/outline.h"
#include "perspective/far.h"
#include "polygon/kind.h"
#include "polygon/setup.h"

/* What leaves hidden pixels out of polygons that are drawn front to back. */
struct cover {
    /* Leaves hidden lines of a table that is just made without pixels. */
    void (*lines)(const struct setup *s);
    /* Draws the table of s->span by the kind of span of s. */
    void (*span)(struct setup *s);
    /* Draws lines of LEVEL_LINES, as perspective_draw. */
    void (*level)(const struct setup *s);
    /* Places lines that are drawn from their far ends. cuts: they may end early. */
    void (*far)(const struct setup *s, struct far_line *lines, int32 leftwards, int32 cuts);
};

/* Makes the scanline table in the form that a kind of span reads. */
static inline void make_lines(struct setup *s, enum span_kind kind)
{
    const struct line_routines *routines = &line_routines[kind_lines[kind]];

    outline_lines(s, EDGES_ARE_EXACT(s->material->edges) ? routines->exact_edges : routines->edges,
                  routines->scissor);
}

/* Returns non-zero if the mapper has a range that u and v of every pixel must stay in. */
static inline int32 has_range(const struct setup *s)
{
    return (s->material->mapper == MAPPER_GOURAUD || s->material->mapper == MAPPER_ARBITRARY)
        && s->kind > SPAN_FILL_32;
}

/* Draws the lines of the plan, unless they are only counted. */
static inline void draw_span(struct setup *s, const struct cover *cover)
{
    if (s->counts && s->renderer->only_counts)
        return;
    if (cover)
        cover->span(s);
    else
        kind_spans[s->kind](&s->span);
}

/* Draws a polygon whose outline and span are set. */
enum polygon_result setup_draw(struct setup *s);

/* SPAN_PERSPECTIVE: draws with perspective. Returns 0 without drawing if the planes are too inexact, too
   steep or too wide: affine spans then draw the polygon. */
int32 perspective_polygon(struct setup *s);

/* GRADIENTS_POLYGON, or START_TRUNCATED by a plane that is there: finds the steps and the starts on the
   left edges. */
enum polygon_result starts_find(struct setup *s);

/* Moves u, v, du and dv of edges from the first pixels, where texturing_starts puts them, back to where the edges
   cross the lines. */
void texturing_crossings(const struct texturing *t, struct edge *edges, int32 count);

/* As texturing_edges, but moved to the first pixels. No line is wider than `width` pixels. */
void texturing_pixels(const struct texturing *t, struct edge *edges, int32 count, int32 width);

/* GRADIENTS_SCANLINE: makes the lines, and u and v of each by two divides. */
void scanline_make(struct setup *s);

/* The same: draws line by line, for mappers whose spans have only one pair of steps. */
void scanline_draw(struct setup *s, const struct cover *cover);

#endif
