/* The passes that draw a polygon's lines. */
#ifndef TX_PLAN_H
#define TX_PLAN_H

#include "tx/forms.h"
#include "tx/lower.h"
#include "tx/planes.h"

typedef void tx_pass(const void *in, void *out, const void *constants, int32 count);

/* Coordinates to one tile's texels. */
struct tx_sampling {
    tx_pass *relative;          /* 0: coordinates are relative to the tile already */
    struct tx_axes axes;
    tx_pass *sample;
    const struct tx_decoded *tile;
};

struct tx_plan {
    struct tx_unit *unit;
    const struct tx_planes *planes;
    tx_pass *coordinates;
    union {
        struct tx_iterators walk;
        struct tx_division division;
        struct tx_lod_steps lod;
    } steps;
    int32 levels;               /* each pixel has tiles and a fraction of its own */
    int32 tile0, tile1;         /* where it has not */
    int32 second_texel;         /* texel 1 is needed */
    struct tx_sampling tiles[TX_TILES];
    struct tx_form form;
    uint32 shade;               /* R G B A, where it is the same everywhere */
    const uint8 *tables;        /* TX_SECOND_TABLES: 256 of R, G, B, A each */
};

/* Finds the passes for a polygon; 0: there are none for these modes or tiles, or memory is
   short. */
int32 tx_plan_find(struct tx_plan *plan, const struct tx_needs *needs, struct tx_unit *unit,
                   const struct tx_planes *planes);

/* line.c: of the line being drawn. */
extern struct tx_blending tx_line_blendings[];

/* line.c. Draws pixels x to x + count - 1 of line y. */
void tx_plan_draw(const struct tx_plan *plan, const struct frame *frame, int32 x, int32 y,
                  int32 count);

#endif
