/* Light on polygons with perspective: a pass over the texels that are drawn. */
#ifndef PERSPECTIVE_LIGHT_H
#define PERSPECTIVE_LIGHT_H

#include "polygon/setup.h"
#include "span/logarithm.h"

/* Returns the kind of span that follows the texels; 0 if the polygon is not lit. */
static inline enum span_kind light_kind(const struct setup *s)
{
    return s->affine == SPAN_LIT_WRAP ? SPAN_LIGHT
         : s->affine == SPAN_LIT_GOURAUD ? SPAN_LIGHT_GOURAUD : (enum span_kind)0;
}

/* Keeps the last pixels of lines, which logarithm_lines has emptied as it made `taken`, in start1, which
   flat lines do not use; restores them. */
void light_keep_lines(const struct setup *s, const struct logarithm_line *taken);
void light_restore_lines(const struct setup *s);

/* Lights the pixels of a lit polygon's lines. shades: room for one a line. */
void light_draw(struct setup *s, uint32 *shades);

#endif
