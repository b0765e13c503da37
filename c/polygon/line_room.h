/* Scratch memory that all drawing paths share; undefined between polygons. */
#ifndef LINE_ROOM_H
#define LINE_ROOM_H

#include "compiler.h"

enum { LINE_ROOM = 49152 };     /* bytes: what perspective makes of FRAME_SIDE_MAX lines */

extern uint32 line_room[LINE_ROOM / 4];

#endif
