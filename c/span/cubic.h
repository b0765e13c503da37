/* Lines with perspective from their far ends to the near ones by cubics. u = K + C / q; K is constant over the polygon,
   C grows by the same from line to line. A piece begins with its exact value; behind it 1 / (1 + x), x being q's growth
   over q there, is a cubic for x up to lambda. */
#ifndef CUBIC_H
#define CUBIC_H

#include "span/far.h"

enum cubic_constants {
    /* The error that cubics may make, in units of 1/65536 texel, and the most that lines are raised by; twice that
       and the error are 1/32 and 1/128 texel. */
    CUBIC_ERROR_PIXEL = 1280,
    CUBIC_RAISE_PIXEL = 384,
    CUBIC_ERROR_FINE = 320,
    CUBIC_RAISE_FINE = 96,
    /* The most pixels of a piece, m + 1. Six times the third term are cut by up to 2^-24 texel, which counts
       (m + 1) m (m - 1) / 6 times; the second term m^2 times, or less by what the third, of the other sign, makes of it;
       the first one and the third m times each; and 2 for the rest. */
    CUBIC_LONGEST_PIXEL = 56,
    CUBIC_LONGEST_FINE = 28,
    CUBIC_CUTS_PIXEL = 123,
    CUBIC_CUTS_FINE = 18,
    /* Texels from K, so that U, in units, is below 2^30. */
    CUBIC_REACH = 16383,
    /* log2 of the texels from K for which the first fit is made; for fine they are in the row 2 further on. */
    CUBIC_NEAR = 4,
    CUBIC_ROWS = 13,
    CUBIC_STEEP = 120,          /* texels a pixel: where u grows faster, pixels are exact; 128 do not fit 8.24 */
    /* Units by which lines are raised. For each texel from K: what q is off by times 2^16 / q, a quarter for each step of
       a pixel or line, which are to the nearest of 1.31, and its plane's error, OFF_Q at most; 1/256 for the cuts of the
       factors; 2^(17 - bits) for r's. 1 for K, 4 if it lacks bits, and what s and t are low by at the corners, 3 2^scale
       times the pixel's shares of them, which are 4 at most, all over q, 1 being the nearest vertex'. For C OFF_C of its
       units: two of its start, one of the first line's, one of its steps. */
    CUBIC_OFF_Q = 4096,
    CUBIC_OFF_C = 4
};

/* For each count of texels from K, as a power of two: lambda, 0.32; the factors of the terms of 1 / (1 + x), 0.31: minus
   p1, p2 / p1 and p3 / p2. Made by tmap.build.cubic_fits. */
struct cubic_fit {
    uint32 width;
    int32 factors[3];
};
extern const struct cubic_fit cubic_fits[CUBIC_ROWS];

/* Everything a cubic span needs: it draws the whole table. */
struct cubic_span {
    const struct far_line *lines;       /* q is 1.31 */
    int32 count;                /* lines, 1 or more */
    const void *map;            /* MAP_PAGE */
    uint32 ku, kv;              /* K, 8.24 */
    int32 dcu, dcv, cu, cv;     /* C, U q 2^(shift + 1 - bits) */
    int32 shift, unshift;       /* U, 16.16, is C r / 2^shift, r = 2^(30 + bits) / q; 32 less it */
    int32 factors[3];           /* of r: minus the factors of a fit times dq / 2^(bits - 3) */
    uint16 most, longest;       /* lambda / dq, 16.16; pixels of the longest piece, less one */
    uint32 dcu_low, dcv_low;    /* below dcu and dcv */
    uint32 dq;                  /* 1.31, in the way that lines are drawn */
    uint32 top;                 /* 2^(bits - 2) */
};

/* src68k/span: contracts there. */
void span_cubic_right(const struct cubic_span *span);
void span_cubic_left(const struct cubic_span *span);

#endif
