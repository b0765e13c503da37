/* How much less perspective keeps within a material's tolerance; beside the bound of what is
   drawn then, and in texels of the map. */
#ifndef TOLERANCE_H
#define TOLERANCE_H

#include "polygon/setup.h"

enum {
    TOLERANCE_MAX = 65536       /* one texel: it times q_low >> 16 stays inside 31 bits */
};

/* Whether a triangle may be drawn affine. */
int32 tolerance_is_flat(const struct setup *s);

/* Whether lines may be straight, or their pieces longer than the setting says: then makes
   s->straight or s->setting so. Reads the planes. */
int32 tolerance_is_coarser(struct setup *s);

#endif
