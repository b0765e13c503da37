/* The passes over a line's pixels for Glide's texture unit. Each is a routine of src68k/glide
   (contracts there) that reads the output of the pass before it. count is 1 or more. */
#ifndef GLIDE_PASSES_H
#define GLIDE_PASSES_H

#include "compiler.h"

/* Iterators at a line's first pixel: s and t 14.18, w 2.30. */
struct glide_iterators {
    int32 s, t, w;
};

/* A coordinate pair: s in the upper, t in the lower word, in texels of one level: 12.4 modulo
   2^16, or 8.8 if weights have 8 bits. */
typedef uint32 glide_coordinates;

/* Converts iterators to one level's coordinates. */
struct glide_steps {
    int32 s, t, w;              /* steps of the iterators */
    uint16 shift;               /* from 14.18 to coordinates: 14 + level, or 10 + level */
    uint16 half;                /* half a texel, in coordinates; 0 for point sampling */
    uint16 last_s, last_t;      /* the last texel's coordinate if clamped; 0xffff: wrapped */
    uint16 behind;              /* 1: s and t are 0 where w is negative */
    uint16 bits;                /* of glide_pieces: a piece has 2^bits pixels; */
    uint16 skip, spare;         /* pixels of the first piece before the run, */
    int32 left;                 /* the line's pixels from that piece on; 0: as many as the run's */
};

/* Two channels of a 2x2 quad, the first one in the upper word: the sum corner + fs * s + ft * t +
   fs * ft * st has 256 times the channel in each word. The words of a difference are added as one
   signed 32-bit number, so a negative lower word borrows from the upper one. */
struct glide_pair {
    uint32 st, s, t, corner;
};

struct glide_quad {
    struct glide_pair rb, ga;
};

/* The same for weights of 8 bits: upper + fs * upper_s has 256 times the channel between the upper
   two texels in each word, lower + fs * lower_s between the lower two. */
struct glide_pair_8 {
    uint32 upper_s, upper, lower_s, lower;
};

struct glide_quad_8 {
    struct glide_pair_8 rb, ga;
};

/* A level as texels of four bytes. A coordinate's texel is texels[row << columns_bits | column]:
   column = s >> 4 (or 8, if weights have 8 bits) modulo 2^columns_bits, row likewise. */
struct glide_decoded {
    const uint32 *texels;       /* R G B A */
    const void *quads;          /* struct glide_quad, or glide_quad_8, in the same order; 0 without a
                                   filter */
    uint16 mask_s, mask_t;      /* (columns - 1) << 4, (rows - 1) << 4 */
    uint16 columns_bits, rows_bits;
};

/* 256 log2(number / 2^31), rounded to the nearest, for the numbers from 2^31 to 2^32 - 1 that share
   bits 22 to 30: value for those up to the limit, value + 1 for the others. */
struct glide_logarithm {
    uint32 limit;
    uint16 value, spare;
};

#define GLIDE_LOGARITHMS 512

/* A level of a map that wraps, for a pass that finds each pixel's. */
struct glide_mip {
    uint32 half;                /* half a texel in the line's coordinates, in both words; 0 for points */
    uint16 mask_s, mask_t;      /* as in glide_decoded */
    int32 texels;               /* bytes from here to the level's texels, R G B A, or its quads */
    uint16 columns_bits, shift; /* shift: from the line's coordinates */
};

#define GLIDE_MIPS 9

struct glide_mips {
    const uint16 *lods;         /* of the line's pixels */
    const struct glide_mip *levels;  /* one for each integer part of a LOD */
};

/* A line's levels of detail. */
struct glide_lods {
    int16 lods[4];              /* 8.8, -32,000 at least: the polygon's + bias + dither - 1.0, for
                                   pixels 0, 4, 8, ..., for pixels 1, 5, ... and so on */
    int16 least, most;          /* 0.0 to 8.0 */
    int32 w;                    /* step of w */
    const struct glide_logarithm *logarithms;
};

/* Converts LODs to detail factors. */
struct glide_nearness {
    int16 end;                  /* 8.8: the least LOD with factor 0 */
    uint16 shift;               /* 1 to 8: bits to shift end - LOD right by */
};

/* Four arrays of every fourth texel of a line, from its first, second, third or fourth on. */
struct glide_quarters {
    int32 bytes;                /* from array to array */
};

/* A page of 256x256 of the frame's pixels, and a line's steps over it. pixels: row 0; rows 128 to
   255 are before it in memory. s and t of the iterators and of their steps, times 2^left, are
   8.24: column and row. left: 6 to 10. */
struct glide_paging {
    int32 s, t;                 /* steps */
    uint16 left, spare;
    const void *pixels;
};

/* Texels to mix with, and the factor of each pixel. Steps are bytes from pixel to pixel: 4, in LODs
   2, in detail factors 1, or 0 for a constant. */
struct glide_mix {
    const uint32 *other;
    const uint8 *factors;
    int32 other_step, factor_step;
    uint32 flip;                /* the factor's bits to invert, the same in each byte */
    uint32 one;                 /* 1: factor 255 counts as 1.0; 0: 256 would be 1.0 */
};

/* A table of products: GLIDE_PRODUCTS + n, n an int16, has the product of m, the upper byte of n,
   and the lower one x: x * (m + 1) >> 8. */
enum { GLIDE_PRODUCTS = 0x8000, GLIDE_PRODUCTS_BYTES = 0x10000 };

/* A level as glide_decoded has it, whose filtered texels are m, and the other texels, x. */
struct glide_times {
    const void *quads;
    uint16 mask_s, mask_t;
    uint16 columns_bits, spare;
    const uint32 *other;
    const uint8 *products;      /* the table's middle: + GLIDE_PRODUCTS */
};

/* Inputs of one channel of the combine unit: each points to the channel's byte, to alpha's, or to a
   zero. Steps as in glide_mix. */
struct glide_inputs {
    const uint8 *other, *local, *factor, *added;
    int32 other_step, local_step, factor_step, added_step;
    uint16 flip, invert;        /* 255, or 0 */
};

/* New alphas of the texels, `step` bytes from pixel to pixel, and the bits of the texels, R G B A,
   to invert then. */
struct glide_alphas {
    const uint8 *alphas;
    int32 step;
    uint32 inverted;
};

/* Entry k: 2^(31 + (k + 1/2) / 256) rounded down. Made by tools/tmap/build/glide_logarithms.py. */
extern const uint32 glide_logarithms[256];

/* Makes GLIDE_LOGARITHMS entries from limits as in glide_logarithms. */
void glide_logarithms_make(struct glide_logarithm *logarithms, const uint32 *limits);

/* Make the quads of a row of texels R G B A and the row below. A row's last texel is followed by
   its first. Each quad has (i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1). */
void glide_quads_make(struct glide_quad *quad, const uint32 *upper, const uint32 *lower, uint32 columns);
void glide_quads_8_make(struct glide_quad_8 *quad, const uint32 *upper, const uint32 *lower,
                        uint32 columns);

/* Makes a table of products. */
void glide_products_make(uint8 *table);

typedef void glide_pass(const void *in, void *out, const void *constants, int32 count);

glide_pass glide_walk, glide_walk_clamp, glide_divide, glide_pieces;    /* to coordinates */
glide_pass glide_point, glide_bilinear, glide_bilinear_565, glide_bilinear_8;
glide_pass glide_bilinear_times, glide_bilinear_times_565;
glide_pass glide_point_mips, glide_bilinear_mips, glide_flips;
glide_pass glide_tile_16, glide_tile_32, glide_lod, glide_details, glide_interleave;
glide_pass glide_lerp, glide_scale, glide_modulate, glide_modulate_rgb, glide_add, glide_alpha;
glide_pass glide_combiner, glide_store_565, glide_widen_565;

/* filter_line.c: C versions of glide_bilinear and glide_bilinear_8, without quads. */
glide_pass glide_filter_line, glide_filter_line_8;

#endif
