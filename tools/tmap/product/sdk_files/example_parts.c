/* What example.c draws with: the linker takes no more than that. */
#define WITH_AFFINE
#define WITH_POLYGONS
#define WITH_STEEP
#include "drawing/parts/parts.h"
