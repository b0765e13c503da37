/* The routines for each kind of span. */
#ifndef KIND_H
#define KIND_H

#include "polygon/polygon.h"
#include "span/scanline.h"

typedef void span_routine(const struct span_plan *plan);
typedef void edge_routine(const struct edge_plan *plan);

/* The form of u and v in a line, if it has them: written by edges, read by spans. */
enum line_form { LINES_FLAT, LINES_ADDX, LINES_SWAP, LINES_PLAIN, LINE_FORMS };

struct line_routines {
    edge_routine *edges, *exact_edges;
    void (*lines[2])(void);     /* the same for assembly, rounded and exact; 0: none */
    void (*scissor)(const struct scissor_plan *plan);
};

/* span_<name> of each kind. src68k/span: contracts there; span_affine_c: c/span. */
#define SPAN(kind, name, lines) void span_##name(const struct span_plan *plan);
#define OTHER(kind, name)
SPAN_LIST(SPAN, OTHER)
#undef SPAN
#undef OTHER

extern const struct line_routines line_routines[LINE_FORMS];

struct mapper_traits {
    uint8 layout, bytes, is;    /* see MAPPER_LIST */
    uint8 kind[3];              /* enum span_kind, for 1, 2 and 4 bytes a pixel */
    uint8 spare[2];
};

extern const struct mapper_traits mappers[MAPPER_KINDS];

/* By enum span_kind; 0 for kinds that polygon_draw does not draw. Two tables, so that a program of
   one scene holds only a byte for a kind that it does not need. */
extern span_routine *const kind_spans[SPAN_KINDS];
extern const uint8 kind_lines[SPAN_KINDS];      /* enum line_form */

#endif
