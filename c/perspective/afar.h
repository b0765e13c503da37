/* How a polygon is drawn from the far ends of its lines. */
#ifndef PERSPECTIVE_AFAR_H
#define PERSPECTIVE_AFAR_H

#include "perspective/cubic.h"
#include "perspective/far.h"

union afar {
    struct far_way way;         /* by settings with straight pieces */
    struct cubic_span cubics;   /* by the others */
};

#endif
