/* Levels of light for polygons that are lit by a table. */
#ifndef SHADING_H
#define SHADING_H

#include "polygon/setup.h"

enum {
    LEVEL_BITS = 18,            /* a shade's level is shade >> LEVEL_BITS */
    SHADE_INSET = 65536 / 16    /* how far Gouraud's shades are kept inside the vertices' range */
};

/* The level of a shade, 16.16: a quarter of it. */
#define SHADE_LEVEL(shade) ((shade) >> (LEVEL_BITS - 16))

/* src68k/polygon: contract there. */
void shade_vertices(struct vertex *to, const struct vertex *from, int32 count, int32 mask);

/* Makes the limits of shades that keep every pixel in the vertices' range, from the vertices' least and
   greatest shade. */
static inline void shade_limits(fix16 *low, fix16 *high)
{
    *low = (*low & ~0xffff) + SHADE_INSET;
    *high = (*high | 0xffff) - SHADE_INSET;
}

static inline fix16 shade_limited(fix16 shade, fix16 low, fix16 high)
{
    return shade < low ? low : shade > high ? high : shade;
}

/* Sets the light of a span plan to the row of a shade; returns 0 if the material has no light
   table. */
int32 shading_light(struct span_plan *span, const struct material *material, fix16 shade);

/* MAPPER_LIT_GOURAUD: sets the levels of the lines from the polygon's plane, for span_lit_gouraud or, with
   SPAN_PERSPECTIVE, span_light_gouraud. The lines are already cut to the frame. No pixel's level is
   outside the vertices' range. shades: one a line. */
void shading_lines(struct setup *s, uint32 *shades);

#endif
