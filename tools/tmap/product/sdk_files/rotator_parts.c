/* What rotator.c draws with. */
#define WITH_AFFINE
#define WITH_POLYGONS
#define WITH_STEEP
#include "drawing/parts/parts.h"
