/* Cheaper perspective within a material's tolerance, in texels of the map. The error bound of the
   cheaper method comes on top. */
#ifndef TOLERANCE_H
#define TOLERANCE_H

#include "perspective/perspective.h"

enum {
    TOLERANCE_MAX = 65536       /* one texel: the product with q_low >> 16 fits 31 bits */
};

/* Returns 1 if a triangle may be drawn affine. */
int32 tolerance_is_flat(const struct setup *s);

/* Returns 1 if lines may be straight, or their pieces longer than the setting's; then sets
   s->level or s->setting. Reads the planes. */
int32 tolerance_is_coarser(struct setup *s);

/* Returns log2 of the pixels of the longest straight pieces, 8 to 64, that are off by at most `most` units, all that
   they are rounded by included; 0 if there are none. most: 256 or more. */
int32 tolerance_straight(const struct perspective_plan *plan, fix16 most);

#endif
