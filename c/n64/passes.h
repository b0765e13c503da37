/* The passes over a line's pixels. Each is a routine of src68k/n64 (contracts there) that reads
   the output of the pass before it. count is 1 or more. */
#ifndef N64_PASSES_H
#define N64_PASSES_H

#include "compiler.h"

/* Iterators at a line's first pixel, or their steps: s15.16. The upper 16 bits are s and t (s10.5)
   or, with perspective, s * w, t * w and w (0x7fff is 1.0). */
struct n64_iterators {
    int32 s, t, w;
};

/* A coordinate pair: s in the upper, t in the lower word, both s10.5. */
typedef uint32 n64_coordinates;

/* One triangle of a 2x2 quad: a corner, and the differences of its neighbours in s and t.
   Each long has two channels: R and B, or G and A, the first one in the upper word. The corner
   is 8 * (32 * channel + 16), a difference 8 * (channel - corner's channel). The words of a
   difference are added as one signed 32-bit number, so a negative lower word borrows from the
   upper one. */
struct n64_triangle {
    uint32 rb_s, rb_t, rb, ga_s, ga_t, ga;
};

/* Texel c00 and its neighbours, prepared for the filters. The corner of lower is c00. The corner
   of upper is c11; its neighbour in s is c01, in t c10. */
struct n64_quad {
    struct n64_triangle lower, upper;
    uint32 mean_rb, mean_ga;    /* as rb and ga: 8 * (8 * (c00 + c10 + c01 + c11) + 16) */
    uint32 spare[2];
};

/* The row below a row of texels, for making quads. Texels are read and quads written step apart;
   a texel's neighbour in s is step texels on. */
struct n64_quad_row {
    const uint32 *below;
    int32 step;
};

/* A tile as texels of four bytes. A relative coordinate's texel is texels[row << columns_bits |
   column]: column = s >> 5 modulo 2^columns_bits, row likewise. */
struct n64_decoded {
    const uint32 *texels;       /* R G B A */
    const struct n64_quad *quads;       /* the same order; 0 without a filter */
    uint16 mask_s, mask_t;      /* (columns - 1) << 5, (rows - 1) << 5 */
    uint16 columns_bits, rows_bits;
};

/* Converts coordinates to relative ones, for one axis. */
struct n64_axis_range {
    int16 shift;                /* bits to the right; negative: to the left */
    uint16 clamp;               /* 0: only low is used, and coordinates wrap */
    int16 low, high;            /* s10.5: the origin; the last texel is shown from here on */
    int16 last;                 /* that texel's relative coordinate, without a fraction */
};

struct n64_axes {
    struct n64_axis_range s, t;
};

/* perspective.c. 2^20 / (64 + i), rounded; entry 6 is one less, as in the hardware. */
extern const uint16 n64_inverses[65];

#define N64_RECIPROCALS 32768   /* longs: 128 KB */

/* Steps of the iterators, and the reciprocal of each w. */
struct n64_division {
    int32 s, t, w;
    const uint32 *reciprocals;
};

/* Texels 1 and their weights: 9 bits signed, 256 is 1.0. */
struct n64_blend {
    const uint32 *other;
    const int16 *fractions;
    int32 fraction_step;        /* bytes: 2, or 0 for the same everywhere */
};

/* Colours at a line's first pixel, or their steps: 16.16. */
struct n64_shades {
    int32 r, g, b, a;
};

/* Factors of a multiplication: one texel a pixel, or one for all pixels. */
struct n64_modulation {
    const uint32 *other;
    int32 step;                 /* bytes: 4, or 0 for the same everywhere */
};

/* Factors of intensities, and the colours of the 256 products. */
struct n64_intensities {
    const uint32 *other, *colours;
};

/* The four channels of a pixel between the combiner's cycles: R G B A. */
struct n64_wide {
    int16 channels[4];
};

/* The addends of U and of V to Y, indexed by U + 128 and V + 128; made from K0 to K3. Green's is
   9.8 in the upper 17 bits, because those of U and V are added before rounding, blue's or red's is
   rounded, in the lower 9: all modulo 512, and a sum of two longs is that of each. */
struct n64_matrix {
    uint32 u[256], v[256];
};

/* From YUV to R G B A = Y. */
struct n64_yuv_conversion {
    const uint32 *chroma;       /* texels: U + 128, V + 128, any, any */
    const struct n64_matrix *matrix;
    const uint32 *colours;      /* for n64_convert: 512 R G B A, by a channel's low 9 bits */
};

/* A YUV tile as n64_decoded has it, of whose texels the filter makes colours. Chroma's quads have V
   in G and U in A. */
struct n64_yuv_filter {
    const struct n64_quad *luma, *chroma;
    uint16 mask_s, mask_t;
    uint16 columns_bits, spare;
    const struct n64_matrix *matrix;
    const uint32 *colours;      /* as in n64_yuv_conversion */
};

/* The inputs of one channel of a combiner cycle and bytes from pixel to pixel, 0 for a
   constant. Each points to the channel's word of an n64_wide, to its alpha, or to a single word. */
struct n64_combination {
    const int16 *a, *b, *c, *d;
    int32 a_step, b_step, c_step, d_step;
};

/* Both tiles of the n64_blending behind a line's last one: there are none. */
enum n64_blending_constants { N64_NO_TILES = 0xffff };

/* Two tiles and the weight of the second: 9 bits signed, 256 is 1.0. */
struct n64_blending {
    uint8 tile0, tile1;
    int16 fraction;
};

enum n64_level_constants { N64_NEAR_LEVELS = 512 };

/* The blending of each level of detail, calculated once for a mode, by the LOD: the longest change
   between pixels. A level's long has the two tiles, the shift that gives the fraction, and 255 if
   the fraction is always that, else 0. */
struct n64_levels {
    uint32 near[N64_NEAR_LEVELS];       /* n64_blending, by the LOD */
    uint32 levels[512];         /* by LOD / 32, from N64_NEAR_LEVELS / 32 on */
    uint32 far;                 /* n64_blending */
};

/* The modes that n64_levels depends on. */
struct n64_level_modes {
    uint8 lod, sharpen, detail; /* 0 or 1 */
    uint8 max_level, min_level, tile;
    uint8 only_blends;          /* 1: nothing but n64_lerp reads fractions. That of a tile and itself
                                   is 0: the second texel is not needed */
    uint8 spare;
};

/* A tile's quads, and the shift of both coordinates to the right; its coordinates need no more. */
struct n64_level_tile {
    uint16 mask_s, mask_t;      /* as of n64_decoded */
    uint32 quads_at;            /* bytes from the sampling's quads on */
    uint32 fractions;           /* 31 in each half, or 0 where an axis has one texel */
    uint16 columns_bits, shift;
};

/* What one texel of each pixel is sampled from. */
struct n64_level_sampling {
    const struct n64_blending *blendings;
    const struct n64_level_tile *tiles; /* 8 */
    const struct n64_quad *quads;
    int16 second;               /* 0: from tile0, 1: from tile1 */
    int16 skips;                /* 1: not where both tiles are the same */
};

/* Steps of the iterators, their gradients in y, tables, and where blendings are written. */
struct n64_lod_steps {
    int32 s, t, w;
    int32 y_s, y_t, y_w;
    const uint32 *reciprocals;
    const struct n64_levels *levels;
    struct n64_blending *blendings;
};

/* Copies a page's row; longs is a multiple of 32. */
void n64_copy_row(const uint32 *row, uint32 *to, int32 longs);

/* k: K0 to K3. */
void n64_matrix_make(struct n64_matrix *matrix, const int16 *k);
void n64_levels_make(struct n64_levels *levels, const struct n64_level_modes *modes);
void n64_divide_table_make(uint32 *reciprocals);

typedef void n64_pass(const void *in, void *out, const void *constants, int32 count);

n64_pass n64_walk, n64_divide, n64_lod, n64_tile, n64_chroma;   /* iterators, coordinates */
n64_pass n64_point, n64_threepoint, n64_threepoint_levels, n64_threepoint_16, n64_average, n64_quads;
n64_pass n64_lerp, n64_shade, n64_modulate, n64_map, n64_convert, n64_store_16;
n64_pass n64_threepoint_yuv, n64_widen, n64_widen_yuv, n64_combiner, n64_convert_wide, n64_narrow;
n64_pass n64_tile_walked, n64_threepoint_intensity, n64_map_intensity, n64_modulate_intensity;
n64_pass n64_in_c;               /* calls what a struct n64_in_c names */

#endif
