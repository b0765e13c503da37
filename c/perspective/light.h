/* Light on polygons with perspective: a pass over the texels that are drawn. */
#ifndef PERSPECTIVE_LIGHT_H
#define PERSPECTIVE_LIGHT_H

#include "polygon/setup.h"

/* Returns the kind of span that follows the texels; 0 if the polygon is not lit. */
static inline enum span_kind light_kind(const struct setup *s)
{
    return s->affine == SPAN_LIT_WRAP ? SPAN_LIGHT
         : s->affine == SPAN_LIT_GOURAUD ? SPAN_LIGHT_GOURAUD : (enum span_kind)0;
}

/* Lights the pixels of a lit polygon's lines. shades: room for one a line. */
void light_draw(struct setup *s, uint32 *shades);

#endif
