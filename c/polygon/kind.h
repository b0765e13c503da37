/* What draws each kind of span. */
#ifndef KIND_H
#define KIND_H

#include "polygon/polygon.h"
#include "span/scanline.h"

typedef void edge_routine(const struct edge_plan *plan);

struct kind_routines {
    edge_routine *edges, *exact_edges;
    void (*scissor)(const struct scissor_plan *plan);
    void (*span)(const struct span_plan *plan);
};

/* In the order of enum span_kind; none for a perspective. */
extern const struct kind_routines kind_routines[SPAN_KINDS];

#endif
