/* The least that gives a unit's polygon the same picture. */
#ifndef N64_LOWER_H
#define N64_LOWER_H

#include "n64/polygons/unit.h"
#include "polygon/setup.h"

/* A polygon's colours where they are the same at all pixels, and what remains of
   n64->inputs. */
struct n64_needs {
    uint32 inputs;
    struct n64_colour shade;    /* where N64_INPUT_SHADE is not among inputs */
    int32 divided;              /* s and t are divided by w */
};

void n64_lower_inputs(struct n64_needs *needs, struct setup *s, const struct n64 *n64,
                      const uint32 *colours);

/* Whether the pixel is the same everywhere. */
int32 n64_lower_to_flat(const struct n64_needs *needs, struct setup *s);

/* Whether the plain mappers draw it: a page that stands for the tile, the material for them in
   *plain; *vertices are those relative to the tile. */
int32 n64_lower_to_plain(const struct n64_needs *needs, struct setup *s, struct n64_unit *unit,
                         struct material *plain, const struct vertex **vertices);

#endif
