/* Chunky to planar: frames as the bitplanes that AGA shows. */
#ifndef PLANAR_H
#define PLANAR_H

#include "compiler.h"

/* A frame and the planes it goes to. Pitches may be negative. Planes may follow one another
   (plane_pitch: a whole plane) or alternate row by row (plane_pitch: a plane's row). */
struct planar_plan {
    const void *pixels;         /* the first row's first; a multiple of 8 */
    int32 pitch;                /* bytes from row to row of them; a multiple of 8 */
    int32 width;                /* pixels, a multiple of PLANAR_WIDTH, not 0 */
    int32 rows;                 /* 1 or more */
    void *planes;               /* the first row of plane 0, the lowest bit; a multiple of 4 */
    int32 row_pitch;            /* bytes from row to row of a plane; a multiple of 4 */
    int32 plane_pitch;          /* bytes from plane to plane; a multiple of 4 */
};

enum planar_constants {
    PLANAR_WIDTH = 32
};

/* src68k/screen: contracts there. */
void c2p_8(const struct planar_plan *plan);

#endif
