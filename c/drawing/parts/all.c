#include "drawing/parts/named.h"

const uint8 perspective_named[PERSPECTIVE_ROOM] = {
    PERSPECTIVE_NONE, PERSPECTIVE_EVERY16, PERSPECTIVE_EVERY8, PERSPECTIVE_PIXEL, PERSPECTIVE_FINE
};
const uint32 drawing_parts = 0xffffffff;
