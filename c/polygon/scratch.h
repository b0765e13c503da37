/* The caller's memory for one polygon at a time (struct renderer of polygon.h); its content is
   undefined between polygons. */
#ifndef SCRATCH_H
#define SCRATCH_H

#include "limits.h"
#include "polygon/clip.h"
#include "polygon/sides.h"
#include "span/scanline.h"

enum { SCRATCH_ROOM = 49152 };  /* bytes: perspective's lines of a frame of FRAME_SIDE_MAX lines */

struct scratch {
    struct scanline lines[FRAME_SIDE_MAX];
    struct edge left[CLIP_VERTICES_MAX], right[CLIP_VERTICES_MAX];
    struct vertex vertices[POLYGON_VERTICES_MAX];       /* made by material_vertices */
    struct vertex corners[POLYGON_VERTICES_MAX];        /* from which planes are found */
    struct vertex paged[POLYGON_VERTICES_MAX];          /* relative to a texture unit's page */
    struct vertex clipped[2 * CLIP_VERTICES_MAX];
    struct sides clipped_sides;
    struct column_layout columns;
    uint32 room[SCRATCH_ROOM / 4];      /* each drawing path has its own layout */
};

/* Fails to compile if a type is larger than the room. */
#define SCRATCH_FITS(type) extern char scratch_fits[sizeof(type) <= SCRATCH_ROOM ? 1 : -1]

#endif
