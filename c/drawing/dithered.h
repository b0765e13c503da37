/* MAPPER_DITHERED: point samples of the map, moved in a pattern of 2x2 pixels of the frame. */
#ifndef DITHERED_H
#define DITHERED_H

#include "polygon/setup.h"

/* Prepares the starts on the left edges and the plan for span_dithered; sets s->texturing.wraps to
   1 if v may wrap in a span when it is moved, else 0. Call it after texturing_edges with
   CHAIN_NONE, and before the lines are made. */
void dithered_span(struct setup *s);

#endif
