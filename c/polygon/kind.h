/* What draws each kind of span, and which kind a polygon needs. */
#ifndef KIND_H
#define KIND_H

#include "polygon/polygon.h"
#include "polygon/texturing.h"
#include "span/scanline.h"

typedef void edge_routine(const struct edge_plan *plan);

struct kind_routines {
    edge_routine *edges, *exact_edges;
    void (*scissor)(const struct scissor_plan *plan);
    void (*span)(const struct span_plan *plan);
};

/* In the order of enum span_kind; none for a perspective. */
extern const struct kind_routines kind_routines[SPAN_KINDS];

/* The cheapest kind that draws a polygon of this material without a perspective. texturing
   counts but for flat ones and GRADIENTS_SCANLINE. */
enum span_kind kind_of(const struct material *material, const struct frame *frame,
                       enum form form, const struct texturing *texturing);

#endif
