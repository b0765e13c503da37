/* Boxes of a frame in one colour. */
#ifndef BOX_H
#define BOX_H

#include "compiler.h"

struct box_plan {
    uint32 *first;              /* of the first row; a multiple of 4 */
    int32 longwords;            /* in a row, 1 or more */
    int32 rows;                 /* 1 or more */
    int32 pitch;                /* bytes from row to row */
    uint32 pixels;              /* each longword's */
};

/* src68k/span: contract there. */
void box_fill(const struct box_plan *plan);

#endif
