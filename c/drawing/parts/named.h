/* Which parts of polygon_draw a program has: all, or those that drawing/parts/parts.h was given. */
#ifndef DRAWING_NAMED_H
#define DRAWING_NAMED_H

#include "polygon/polygon.h"

enum drawing_part {
    /* bit MAPPER_n: that mapper */
    PART_16 = 1 << MAPPER_KINDS,        /* pixels of two bytes */
    PART_32 = PART_16 << 1,             /* of four */
    PART_STARTS = PART_16 << 2,         /* GRADIENTS_POLYGON, START_TRUNCATED */
    PART_SCANLINE = PART_16 << 3,       /* GRADIENTS_SCANLINE */
    PART_CLIPPING = PART_16 << 4,       /* CLIP_VERTICES */
    PART_PERSPECTIVE = PART_16 << 5,
    PART_CURVES = PART_16 << 6          /* PERSPECTIVE_PIXEL, PERSPECTIVE_FINE */
};

/* How each setting of a material is drawn. */
enum { PERSPECTIVE_ROOM = (PERSPECTIVE_KINDS + 3) & ~3 };   /* of the table: whole longs */
extern const uint8 perspective_named[PERSPECTIVE_ROOM];

extern const uint32 drawing_parts;      /* mappers by their bits, and enum drawing_part */

/* Returns 1 if the program has all that the material needs in a frame of such pixels. polygon_draw does not
   ask: a material is checked when it is made. */
int32 material_is_named(const struct material *material, int32 pixel_bytes);

#endif
