/* One pixel, from iterators to a colour: the reference that all faster code must equal. */
#ifndef N64_PIXEL_H
#define N64_PIXEL_H

#include "n64/passes.h"
#include "n64/texel.h"

/* A pixel's iterators and their gradients in x and y. Their upper 16 bits are s and t (s10.5) or,
   with perspective, s * w, t * w and w (0x7fff is 1.0). */
struct n64_point {
    struct n64_iterators at, dx, dy;
};

/* perspective.c. Coordinates of a pixel: s, t s10.5 within 16 bits; raw_s, raw_t the same before
   the clamp, signed 17 bits; overflow: -1, 0, 1 for each (w <= 0 is 1). */
struct n64_divided {
    int32 s, t, raw_s, raw_t;
    int32 overflow_s, overflow_t;
};

void n64_quotients(int32 s, int32 t, int32 w, struct n64_divided *out);

/* perspective.c. Calculates a pixel's coordinates from iterators, with or without perspective. */
void n64_project(const struct n64 *n64, const struct n64_iterators *at, struct n64_divided *out);

/* lod.c. The two tiles that a pixel shows and the fraction between them: 9 bits signed (0x1c0 is
   -64). */
struct n64_level {
    int32 tile0, tile1, fraction;
};

/* lod.c. at: the divided pixel itself. In one-cycle mode only the neighbour to the right
   counts. */
void n64_level_of_point(const struct n64 *n64, const struct n64_point *point,
                        const struct n64_divided *at, struct n64_level *level);

/* Inputs of the combiner. */
struct n64_sources {
    struct n64_colour texel0, texel1, shade;
    int32 fraction;             /* of the level: 9 bits as n64_level has it */
};

/* combine.c. Returns a pixel's colour: 0 to 255 each, R G B A from the highest byte on. In the
   second of two cycles texel 0 is tile T1's sample and texel 1 this pixel's T0 (the hardware has
   the next pixel's there); in one-cycle mode texel 1 is texel 0. */
uint32 n64_combine_pixel(const struct n64 *n64, const struct n64_sources *sources);

/* pixel.c. A pixel's coordinates, tiles and their two samples, as in two-cycle mode. */
struct n64_pixel {
    struct n64_divided at;
    struct n64_level level;
    struct n64_colour texel0, texel1;
};

void n64_sample_pixel(const struct n64 *n64, const struct n64_point *point, struct n64_pixel *pixel);

/* pixel.c. Returns a pixel's colour in one- or two-cycle mode; shade may be 0 if n64->inputs has
   no N64_INPUT_SHADE. */
uint32 n64_draw_pixel(const struct n64 *n64, const struct n64_point *point,
                      const struct n64_colour *shade);

#endif
