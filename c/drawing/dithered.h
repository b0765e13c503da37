/* MAPPER_DITHERED: points of the map that are moved in a pattern of 2x2 pixels of the frame. */
#ifndef DITHERED_H
#define DITHERED_H

#include "polygon/setup.h"

/* Makes ready what span_dithered needs: the starts on the left edges, its part of the plan, and
   s->texturing.wraps: whether v, moved, may wrap in a span. After texturing_edges with CHAIN_NONE,
   before there are lines. */
void dithered_span(struct setup *s);

#endif
