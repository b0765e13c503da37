/* Chunky to planar: converts frames to AGA's bitplanes. Each call converts a frame or some of its
   rows; for double buffering only planar_plan.planes changes. */
#ifndef PLANAR_H
#define PLANAR_H

#include "compiler.h"

/* A frame and its planes. Pitches may be negative. Planes may follow one another (plane_pitch: a
   whole plane) or alternate row by row (plane_pitch: a plane's row). */
struct planar_plan {
    const void *pixels;         /* the first row; a multiple of 8 */
    int32 pitch;                /* bytes from row to row of pixels; a multiple of 8 */
    int32 width;                /* pixels, not 0, a multiple of 32; of 16 for c2p_8_2x1, of 8 for HAM8 */
    int32 rows;                 /* 1 or more */
    void *planes;               /* the first row of plane 0, the pixels' lowest bits; a multiple
                                   of 4 */
    int32 row_pitch;            /* bytes from row to row of a plane; a multiple of 4 */
    int32 plane_pitch;          /* bytes from plane to plane; a multiple of 4 */
};

/* HAM8 shows a dot by changing one component of the dot to its left: planes 0 and 1 select the
   component, planes 2 to 7 are its upper six bits. Here a frame's pixel is four dots, which change
   red, green, blue, and blue again: planes 0 and 1 are the same for every frame, and each pixel's
   right half has its own colour exactly, whatever its neighbours are. In its left half, one dot
   has the green and two have the blue of the pixel to the left. So a frame of 160 pixels is 640
   dots of high resolution, one of 320 pixels 1280 of super-high resolution. A component's lower
   two bits are those of palette entry 0, with which each line begins: with 2 there, an 8-bit value
   v is shown as v - 1 to v + 2. With 1280 dots a line the eye sees the mean of a pixel's four
   dots. Its red is the pixel's own, its green is off by a quarter and its blue by half of the
   difference from the pixel to the left: at most 2, 2 + |difference| / 4 and
   2 + |difference| / 2. */
#define HAM8_DOTS 4
#define HAM8_PLANE_0 0x77777777u        /* bits of four dots: 0 1 1 1, */
#define HAM8_PLANE_1 0xccccccccu        /* 1 1 0 0: red is 2, green 3, blue 1 */

/* src68k/screen: contracts there. */
void c2p_8(const struct planar_plan *plan);
void c2p_8_2x1(const struct planar_plan *plan);
void c2p_8_blit(const struct planar_plan *plan);
void c2p_8_blits(const struct planar_plan *plan);
void c2p_8_2x1_blit(const struct planar_plan *plan);
void c2p_8_2x1_blits(const struct planar_plan *plan);
void c2p_ham8_16(const struct planar_plan *plan);
void c2p_ham8_5551(const struct planar_plan *plan);
void c2p_ham8_32(const struct planar_plan *plan);

/* Writes planes 0 and 1 of a HAM8 screen, which no frame changes. Ignores pixels and pitch. */
void ham8_control(const struct planar_plan *plan);

#endif
