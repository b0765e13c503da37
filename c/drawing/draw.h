/* The general way of polygon_draw. */
#ifndef DRAW_H
#define DRAW_H

#include "polygon/polygon.h"

/* Draws every polygon. */
polygon_routine polygon_draw_any;

#endif
