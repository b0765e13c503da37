/* GRADIENTS_SCANLINE: u and v along both sides, for any convex polygon. */
#ifndef RAMPS_H
#define RAMPS_H

#include "polygon/edges.h"
#include "span/scanline.h"

/* Makes the ramps of a side's edges. */
void ramps_make(struct ramp *ramps, const struct edge *edges, int32 count);

#endif
