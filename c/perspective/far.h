/* Polygons drawn from the far ends of their lines to the near ones. */
#ifndef PERSPECTIVE_FAR_H
#define PERSPECTIVE_FAR_H

#include "perspective/perspective.h"

/* Returns log2 of the pixels of its pieces, `piece` or 3; 0 if a polygon is not drawn this way. */
int32 far_piece(const struct perspective_plan *planes, int32 piece);

/* Draws all lines of the setup's perspective plan, or none: then it returns 0. The plan has K, which this
   raises, and C. */
int32 far_draw(const struct setup *s, const struct reciprocal_plan *plan, int32 piece);

#endif
