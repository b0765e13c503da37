/* Polygons with perspective that are drawn from the far ends of their lines. */
#ifndef PERSPECTIVE_FAR_H
#define PERSPECTIVE_FAR_H

#include "perspective/perspective.h"

/* Returns the bits by which q may have to be shifted left; below 0 if the polygon is not drawn this way.
   Sets *lowest to the least q. */
int32 far_shift(const struct setup *s, int32 *lowest);

/* Draws the lines of a plan whose bits are FAR_BITS with pieces of up to `longest` pixels, 16 or 8. Returns 0
   if K is too far away. */
int32 far_draw(const struct setup *s, const struct reciprocal_plan *plan, int32 shift, int32 least,
               int32 longest);

/* Draws the lines of the setup's plan by the planes of u and v, where K is too far away. Returns 0 if their
   range is too wide, or they are too steep. */
int32 far_draw_planes(const struct setup *s, int32 shift, int32 longest);

#endif
