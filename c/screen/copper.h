/* Copper lists of a screen: the picture, then the status lines. */
#ifndef COPPER_H
#define COPPER_H

#include "screen/layout.h"

enum copper_constants {
    COPPER_PALETTE = 8 * (1 + 32) * 2,      /* moves */
    COPPER_REST = 80,                       /* moves and waits, at most */
    COPPER_LONGS = COPPER_PALETTE + COPPER_REST,
    BLANK_LONGS = 8,            /* longwords of a list without planes */
    PLANES = 8
};

struct copper_planes {
    const uint8 *plane[PLANES];
    const uint8 *status;        /* STATUS_ROWS of STATUS_PITCH bytes */
};

/* Writes a list with a black palette; returns the address of the palette in it. */
uint16 *copper_list_make(uint16 *list, const struct screen_layout *layout,
                         const struct copper_planes *planes);

/* Writes a list of BLANK_LONGS longwords that shows nothing. */
void copper_blank_make(uint16 *list);

/* Write one entry of a list's palette, or all 256. An entry is 4 bytes: 0, red, green, blue. */
void copper_colour_set(uint16 *palette, uint32 number, const uint8 *colour);
void copper_palette_set(uint16 *palette, const uint8 *colours);

#endif
