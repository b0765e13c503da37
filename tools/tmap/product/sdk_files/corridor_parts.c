/* What corridor.c draws with. */
#define WITH_AFFINE
#define WITH_RECIPROCALS
#define WITH_STEEP
#include "drawing/parts/parts.h"
