/* A polygon's u = K + C / q: K is constant over the polygon and C over the line. */
#ifndef RECIPROCAL_H
#define RECIPROCAL_H

#include "span/perspective.h"

enum reciprocal_constants {
    RECIPROCAL_BITS = 6             /* C is 2^this times as large */
};

struct reciprocal_plan {
    const struct perspective_plan *planes;  /* lines that are taken may be emptied in it */
    struct number64 cu, cv;             /* C * 2^RECIPROCAL_BITS at the first line */
    struct number64 dcu, dcv;           /* steps of these a line */
    fix16 ku, kv;
};

/* src68k/polygon: contract there. */
int32 reciprocal_find(struct reciprocal_plan *plan, int32 x, int32 y);

#endif
