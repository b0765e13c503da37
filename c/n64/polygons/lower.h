/* Finds the cheapest way to draw a unit's polygon with the same picture. */
#ifndef N64_LOWER_H
#define N64_LOWER_H

#include "n64/polygons/unit.h"
#include "polygon/setup.h"

/* Inputs of a polygon that change from pixel to pixel, and the constant values of the others. */
struct n64_needs {
    uint32 inputs;
    struct n64_colour shade;    /* if inputs lacks N64_INPUT_SHADE */
    int32 divided;              /* s and t are divided by w */
};

void n64_lower_inputs(struct n64_needs *needs, struct setup *s, const struct n64 *n64,
                      const uint32 *colours);

/* Returns non-zero if the plain mappers can draw the polygon from a page. Makes the page, sets
   *plain to the material for them and *vertices to the vertices relative to the page. */
int32 n64_lower_to_plain(const struct n64_needs *needs, struct setup *s, struct n64_unit *unit,
                         struct material *plain, const struct vertex **vertices);

#endif
