#include "polygon/line_room.h"

uint32 line_room[LINE_ROOM / 4];
