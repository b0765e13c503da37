/* The caller's memory for one polygon at a time (struct renderer of polygon.h); its content is
   undefined between polygons. */
#ifndef SCRATCH_H
#define SCRATCH_H

#include "limits.h"
#include "polygon/clip.h"
#include "polygon/sides.h"
#include "span/scanline.h"

enum scratch_constants {
    SCRATCH_LINE = 48,          /* bytes of the room for a line of the frame, or a column: perspective's */
    SCRATCH_LEAST = 15360,      /* for all else but texture units' polygons */
    SCRATCH_ROOM = FRAME_SIDE_MAX * SCRATCH_LINE        /* for any frame, and for units */
};

struct scratch {
    struct scanline lines[FRAME_SIDE_MAX];
    struct edge left[CLIP_VERTICES_MAX], right[CLIP_VERTICES_MAX];
    struct vertex vertices[POLYGON_VERTICES_MAX];       /* made by material_vertices */
    struct vertex corners[POLYGON_VERTICES_MAX];        /* from which planes are found */
    struct vertex paged[POLYGON_VERTICES_MAX];          /* relative to a texture unit's page */
    struct vertex clipped[2 * CLIP_VERTICES_MAX];
    struct sides clipped_sides;
    struct column_layout columns;
    uint32 room[SCRATCH_ROOM / 4];      /* each drawing path has its own layout; less is there for small frames */
};

/* Returns the bytes of a struct scratch that a frame needs; its room's end is left out. has_units: texture units
   draw into it. */
static inline int32 scratch_bytes(int32 width, int32 height, int32 has_units)
{
    const int32 lines = (width > height ? width : height) * SCRATCH_LINE;
    const int32 room = has_units ? SCRATCH_ROOM : lines > SCRATCH_LEAST ? lines : SCRATCH_LEAST;

    return (int32)sizeof(struct scratch) - SCRATCH_ROOM + room;
}

/* These fail to compile if a type is larger than its room: of any polygon; of a line's; of a unit's polygon. */
#define SCRATCH_FITS(type) extern char scratch_fits[sizeof(type) <= SCRATCH_LEAST ? 1 : -1]
#define SCRATCH_FITS_LINE(type) extern char scratch_fits[sizeof(type) <= SCRATCH_LINE ? 1 : -1]
#define SCRATCH_FITS_UNIT(type) extern char scratch_fits[sizeof(type) <= SCRATCH_ROOM ? 1 : -1]

#endif
