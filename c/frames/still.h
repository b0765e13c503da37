/* A scene in which nothing moves, written ready to draw by tools/tmap/product/still.py: what its program
   holds in place of the scene file. src68k/amiga/still.s walks these tables. */
#ifndef STILL_H
#define STILL_H

#include "polygon/polygon.h"

/* The start. Behind it: maps; pointers to fields; calls that make tables. Each list ends with a 0. */
struct still {
    int32 frames;
    uint8 *pixels;              /* of the frame */
    int32 bytes;                /* the same */
    uint8 *pages;               /* room for maps and what a multiple of 65,536 needs before it; 0: no map is
                                   copied */
};

/* A map that is copied to a page. Row v of it is row `v & mask` of its texels. */
struct still_map {
    const uint8 *from;
    int32 to;                   /* from the first page's start; so much is added to the fields */
    int16 mask;
    uint16 longs;               /* of a row in the file, less 1 */
    int16 repeats, rows;        /* of a row; of the map: less 1 */
};

/* One step of the drawing. */
struct still_call {
    void (*routine)(void *with);
    void *with;
};

/* Polygons of one material that are not prepared further. */
struct still_run {
    struct renderer *renderer;
    const struct polygon *polygons;
    const struct material *material;
    int32 count;
};

void still_run(const struct still_run *run);

/* Draws the picture: src68k/amiga. */
void still_draw(void);

/* The same, timed as scene_time does, for the tools: prints a line, colour clocks. */
void still_time(void);

#endif
