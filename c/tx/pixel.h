/* One pixel, from iterators to a colour: the arithmetic that every quicker way must equal. */
#ifndef TX_PIXEL_H
#define TX_PIXEL_H

#include "tx/passes.h"
#include "tx/texel.h"

/* A pixel's iterators, and what they grow by to the right and downwards. Their upper 16 bits
   are s and t (s10.5) or, with perspective, s * w, t * w and w (0x7fff is 1.0). */
struct tx_point {
    struct tx_iterators at, dx, dy;
};

/* perspective.c. Coordinates of a pixel: s, t s10.5 within 16 bits; raw_s, raw_t the same before
   the clamp, signed 17 bits; overflow: -1, 0, 1 for each (w <= 0 is 1). */
struct tx_divided {
    int32 s, t, raw_s, raw_t;
    int32 overflow_s, overflow_t;
};

void tx_quotients(int32 s, int32 t, int32 w, struct tx_divided *out);

/* perspective.c. The same for iterators: with or without perspective. */
void tx_project(const struct tx *tx, const struct tx_iterators *at, struct tx_divided *out);

/* lod.c. Which tiles a pixel shows, and between them: 9 bits, of which the highest makes it
   negative (0x1c0 is -64). */
struct tx_level {
    int32 tile0, tile1, fraction;
};

/* lod.c. at: the divided pixel itself. In one-cycle mode only the neighbour to the right
   counts. */
void tx_level_of_point(const struct tx *tx, const struct tx_point *point,
                       const struct tx_divided *at, struct tx_level *level);

/* What the combiner chooses from. */
struct tx_sources {
    struct tx_colour texel0, texel1, shade;
    int32 fraction;             /* of the level: 9 bits as tx_level has it */
};

/* combine.c. A pixel's colour: 0 to 255 each, R G B A from the highest byte on. In the second
   of two cycles texel 0 is tile T1's sample and texel 1 this pixel's T0 (the hardware has the
   next pixel's there); in one-cycle mode texel 1 is texel 0. */
uint32 tx_combine_pixel(const struct tx *tx, const struct tx_sources *sources);

/* pixel.c. Tiles and their two samples, as in two-cycle mode. */
struct tx_pixel {
    struct tx_divided at;
    struct tx_level level;
    struct tx_colour texel0, texel1;
};

void tx_sample_pixel(const struct tx *tx, const struct tx_point *point, struct tx_pixel *pixel);

/* pixel.c. The whole way in one- and two-cycle mode; shade may be 0 where inputs lacks it. */
uint32 tx_draw_pixel(const struct tx *tx, const struct tx_point *point,
                     const struct tx_colour *shade);

#endif
