/* The passes that draw a polygon's lines. */
#ifndef TX_PLAN_H
#define TX_PLAN_H

#include "tx/lower.h"
#include "tx/passes.h"
#include "tx/planes.h"

typedef void tx_pass(const void *in, void *out, const void *constants, int32 count);

/* Coordinates to one tile's texels. */
struct tx_sampling {
    tx_pass *relative;          /* 0: coordinates are relative to the tile already */
    struct tx_axes axes;
    tx_pass *sample;
    const struct tx_decoded *tile;
};

/* In order; 0: not needed. */
struct tx_plan {
    tx_pass *coordinates;
    struct tx_division division;        /* or steps */
    struct tx_sampling texel[2];        /* the first always; the second's sample may be 0 */
    tx_pass *combine;           /* from the first texels, into them or the frame */
    struct tx_blend blend;
    tx_pass *store;             /* to the frame, whose pixels are not texels */
};

/* Finds the passes for a polygon; 0: there are none for these modes or tiles. */
int32 tx_plan_find(struct tx_plan *plan, const struct tx_needs *needs, const struct setup *s,
                   struct tx_unit *unit, const struct tx_planes *planes);

/* Draws pixels x to x + count - 1 of line y. */
void tx_plan_draw(const struct tx_plan *plan, const struct tx_planes *planes,
                  const struct frame *frame, int32 x, int32 y, int32 count);

#endif
