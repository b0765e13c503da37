/* Polygons with perspective whose lines are columns of the frame: walls, seen by an upright camera. */
#ifndef DRAWING_COLUMNS_H
#define DRAWING_COLUMNS_H

#include "polygon/setup.h"

/* Draws a polygon of LEVEL_COLUMNS: the pixels that its lines would have. Returns 0 if a column bends too
   much: nothing is drawn then. */
int32 columns_draw(struct setup *s);

#endif
