#include "drawing/parts/named.h"

const uint32 drawing_parts = 0xffffffff;
