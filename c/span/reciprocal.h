/* A polygon's u = K + C / q: K is constant over the polygon and C over the line. */
#ifndef RECIPROCAL_H
#define RECIPROCAL_H

#include "span/perspective.h"

enum reciprocal_constants {
    RECIPROCAL_BITS = 6             /* of a plan for lines by logarithms */
};

struct reciprocal_plan {
    const struct perspective_plan *planes;  /* lines that are taken may be emptied in it */
    int32 bits;                         /* 6, or 3: K then may be 8 times as far away */
    struct number64 cu, cv;             /* C * 2^bits at the first line */
    struct number64 dcu, dcv;           /* steps of these a line */
    fix16 ku, kv;
};

/* src68k/polygon: contract there. */
int32 reciprocal_find(struct reciprocal_plan *plan, int32 x, int32 y);

#endif
