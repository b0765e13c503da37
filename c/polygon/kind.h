/* The routines for each kind of span. */
#ifndef KIND_H
#define KIND_H

#include "polygon/polygon.h"
#include "span/scanline.h"

typedef void span_routine(const struct span_plan *plan);
typedef void edge_routine(const struct edge_plan *plan);

/* The form of u and v in a line, if any: written by edges, read by spans. */
enum line_form { LINES_FLAT, LINES_ADDX, LINES_SWAP, LINES_PLAIN, LINE_FORMS };

struct line_routines {
    edge_routine *edges, *exact_edges;
    void (*scissor)(const struct scissor_plan *plan);
};

extern const struct line_routines line_routines[LINE_FORMS];

/* In the order of enum span_kind; empty for kinds that polygon_draw does not draw. The tables are
   separate, so that a program of one scene holds only a byte for a kind that it does not need. */
extern span_routine *const kind_spans[SPAN_KINDS];
extern const uint8 kind_lines[SPAN_KINDS];      /* enum line_form */

#endif
