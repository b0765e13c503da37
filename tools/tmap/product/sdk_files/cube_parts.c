/* What cube.c draws with, and polygon_draw where a triangle is not inside the frame. */
#define WITH_AFFINE
#define WITH_POLYGONS
#define WITH_SNAPPED
#define WITH_STEEP
#include "drawing/parts/parts.h"
