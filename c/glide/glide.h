/* Glide's texture unit (GLIDE): its state, and the calls and registers that change it.

   A program may have any number of units, each with its own texture memory.
   Coordinates s and t run from 0 to 256 along a map's longer side. Formats: 14.18 and 2.30 are
   signed, 32 bits; LOD is 8.8, signed: 0.0 is one texel of level 0 a pixel, 1.0 two.
   Levels: n = 0 is 256 texels long, each of the next half as long, 8 a single texel.
   Texels of 16 bits are little-endian in texture memory, as on the PC's bus. Callers pass them in
   the 68020's byte order. */
#ifndef GLIDE_H
#define GLIDE_H

#include "compiler.h"

enum glide_format {
    GLIDE_RGB332, GLIDE_YIQ422, GLIDE_A8, GLIDE_I8, GLIDE_AI44, GLIDE_P8,
    GLIDE_ARGB8332 = 8,         /* 16 bits from here on */
    GLIDE_AYIQ8422, GLIDE_RGB565, GLIDE_ARGB1555, GLIDE_ARGB4444, GLIDE_AI88, GLIDE_AP88,
    GLIDE_FORMATS
};

/* Columns x rows. */
enum glide_aspect {
    GLIDE_8X1, GLIDE_4X1, GLIDE_2X1, GLIDE_1X1, GLIDE_1X2, GLIDE_1X4, GLIDE_1X8, GLIDE_ASPECTS
};

/* Which of a map's levels a unit holds: bit 0 even, bit 1 odd ones. */
enum glide_levels { GLIDE_EVEN = 1, GLIDE_ODD = 2, GLIDE_BOTH = 3 };

enum glide_filtering { GLIDE_POINT, GLIDE_BILINEAR };
enum glide_wrapping { GLIDE_WRAP, GLIDE_CLAMP };
enum glide_mipmapping { GLIDE_MIPMAP_OFF, GLIDE_NEAREST, GLIDE_NEAREST_DITHER };

/* Functions of other, the colour from upstream, and local, the unit's own; m is the factor. */
enum glide_function {
    GLIDE_ZERO,
    GLIDE_LOCAL,
    GLIDE_LOCAL_ALPHA,
    GLIDE_SCALE_OTHER,                          /* other m */
    GLIDE_SCALE_OTHER_ADD_LOCAL,
    GLIDE_SCALE_OTHER_ADD_LOCAL_ALPHA,
    GLIDE_SCALE_OTHER_MINUS_LOCAL,              /* (other - local) m */
    GLIDE_BLEND,                                /* (other - local) m + local */
    GLIDE_BLEND_ADD_LOCAL_ALPHA,                /* (other - local) m + local alpha */
    GLIDE_BLEND_LOCAL,                          /* local - local m */
    GLIDE_BLEND_LOCAL_ADD_LOCAL_ALPHA,          /* local alpha - local m */
    GLIDE_FUNCTIONS
};

enum glide_factor {
    GLIDE_FACTOR_ZERO,
    GLIDE_FACTOR_LOCAL,                         /* the same channel of local */
    GLIDE_FACTOR_OTHER_ALPHA,
    GLIDE_FACTOR_LOCAL_ALPHA,
    GLIDE_FACTOR_DETAIL,
    GLIDE_FACTOR_LOD_FRACTION,
    GLIDE_FACTOR_ONE = 8,                       /* from here on: one minus the factor 8 less */
    GLIDE_FACTOR_ONE_MINUS_LOCAL,
    GLIDE_FACTOR_ONE_MINUS_OTHER_ALPHA,
    GLIDE_FACTOR_ONE_MINUS_LOCAL_ALPHA,
    GLIDE_FACTOR_ONE_MINUS_DETAIL,
    GLIDE_FACTOR_ONE_MINUS_LOD_FRACTION
};

enum glide_constants {
    GLIDE_LEVEL_LAST = 8,
    GLIDE_LEVEL_TEXELS = 4,     /* the least room of a level */
    GLIDE_START_ALIGN = 8,
    GLIDE_ENTRIES = 256,        /* of the palette */
    GLIDE_NCC_TABLES = 2,
    GLIDE_NCC_REGISTERS = 12,   /* of a table */
    GLIDE_LOD_ONE = 256,        /* LOD 1.0 */
    GLIDE_LOD_LEAST = -32768,   /* for gradients of 0: low enough for all that is added */
    GLIDE_LOD_MOST = 32767,     /* for 1/w = 0, which is infinitely far away */
    GLIDE_UNITS = 2             /* in a row */
};

/* Results of a call, and their texts. Unless it is GLIDE_DONE, nothing was changed. */
#define GLIDE_RESULT_LIST(RESULT) \
    RESULT(DONE, "done") \
    RESULT(BAD_MEMORY, "texture memory is not a power of two of at least 8 bytes") \
    RESULT(BAD_START, "start address is no multiple of 8")  /* GLIDE_START_ALIGN */ \
    RESULT(OUTSIDE_MEMORY, "map goes beyond texture memory") \
    RESULT(BAD_LEVEL, "no such level")  /* above 8 */ \
    RESULT(BAD_LEVEL_ORDER, "smallest level is larger than the largest") \
    RESULT(BAD_LEVELS, "levels are not even, odd or both")  /* enum glide_levels */ \
    RESULT(NO_LEVEL, "map has no level of this kind") \
    RESULT(LEVEL_NOT_HELD, "level is not in this map")  /* or not in this unit */ \
    RESULT(BAD_ROWS, "rows are not in the level")  /* the last before the first, or too large */ \
    RESULT(BAD_ASPECT, "no such aspect ratio") \
    RESULT(BAD_FORMAT, "no such format") \
    RESULT(BAD_ENTRIES, "entries are not in the palette")  /* as BAD_ROWS */ \
    RESULT(BAD_NCC_TABLE, "no such NCC table") \
    RESULT(BAD_NCC_VALUE, "NCC value is not within -256 to 255") \
    RESULT(BAD_FILTER, "no such filter") \
    RESULT(BAD_WRAPPING, "neither wrap nor clamp") \
    RESULT(BAD_MIPMAP, "no such mipmap mode") \
    RESULT(BAD_LOD_BIAS, "LOD bias is not within -8.0 to 7.75") \
    RESULT(BAD_DETAIL_BIAS, "detail bias is not within -32 to 31") \
    RESULT(BAD_DETAIL_SCALE, "detail scale is not within 0 to 7") \
    RESULT(BAD_DETAIL_MAX, "greatest detail is not within 0 to 255") \
    RESULT(BAD_FUNCTION, "no such combine function") \
    RESULT(BAD_FACTOR, "no such combine factor") \
    RESULT(BAD_FLAG, "flag is neither 0 nor 1") \
    RESULT(BAD_FRACTION_BITS, "weights have neither 4 nor 8 bits") \
    RESULT(BAD_SUBDIVISION, "pieces have neither 8 nor 16 pixels")  /* or 0 */ \
    RESULT(BAD_REGISTER, "register has bits that mean nothing") \
    RESULT(BAD_UNITS, "not one or two units, or hints beyond them") \
    RESULT(BAD_COORDINATE, "s or t of a vertex is 8,192 or more, or of two so far apart") \
    RESULT(BAD_W, "w of a vertex is 0, or above 16,384")  /* W_MAX */ \
    RESULT(NO_COORDINATES, "a unit's own coordinates are missing")

enum glide_result {
#define RESULT(name, text) GLIDE_##name,
    GLIDE_RESULT_LIST(RESULT)
#undef RESULT
    GLIDE_RESULTS
};

struct glide_combination {
    uint8 zero_other, sub_local;
    uint8 mselect;              /* 0 none, 1 local, 2 other alpha, 3 local alpha, 4 detail, 5 LOD */
    uint8 reverse;              /* 0: the factor is inverted */
    uint8 add_local, add_alpha_local, invert;
};

/* A field for each setting of the registers textureMode, tLOD, tDetail and texBaseAddr. */
struct glide_modes {
    uint8 perspective, minify, magnify;         /* filters: enum glide_filtering */
    uint8 clamp_negative_w, dither, ncc_table;
    uint8 clamp_s, clamp_t, format;
    struct glide_combination rgb, alpha;
    uint8 trilinear;
    uint8 lod_min, lod_max;     /* 4.2, unsigned */
    int8 lod_bias;              /* s4.2 */
    uint8 odd, split;           /* split: only odd levels, or only even ones, are there */
    uint8 wide, aspect;         /* wide: s is the longer side; the other is longer >> aspect */
    uint8 detail_max;
    int8 detail_bias;
    uint8 detail_scale;
    uint8 fraction_bits;        /* of filter weights: 4, or 8 as in Voodoo 2 */
    uint8 table_quotients;      /* 1: s / w by a table of reciprocals, as in hardware; 0: exact */
    uint8 dithered;             /* 1: moved points replace the bilinear filter where possible
                                   (unit.h); 0: it is exact */
    uint8 subdivision;          /* glide_subdivision: 0, 8 or 16 pixels */
    uint8 spare[2];
    uint32 base;                /* bytes: where level 0 would start */
};

/* A byte yyyyiiqq means y[yyyy] + i[ii] + q[qq], each channel clamped to 0 to 255. */
struct glide_ncc {
    uint8 y[16];
    int16 i[4][3], q[4][3];     /* R G B: -256 to 255 */
};

struct glide {
    struct glide_modes modes;
    uint8 *memory;
    uint32 memory_bytes;        /* a power of two; addresses wrap at it */
    uint32 palette[GLIDE_ENTRIES];      /* 00RRGGBB */
    struct glide_ncc ncc[GLIDE_NCC_TABLES];
    /* Generation counters: a cache that was made from a part is stale when its counter differs. */
    uint32 memory_generation, table_generation, mode_generation;
    uint8 largest, smallest;    /* levels of the map that is drawn from */
    uint8 mipmap;               /* enum glide_mipmapping */
    uint8 spare;
};

/* A map for glide_source and the downloads. */
struct glide_texture {
    uint32 largest, smallest;   /* levels: 0-8 */
    uint32 aspect, format;      /* enum glide_aspect, enum glide_format */
};

/* Sets everything to 0, so both filters are point sampling, except: the unit's colour is its texel,
   mipmaps are on, s is the longer side and weights have 4 bits. Does not change the memory. */
enum glide_result glide_init(struct glide *glide, uint8 *memory, uint32 bytes);

/* Sets *bytes to the bytes that a map's levels take from a start address on, a multiple of
   GLIDE_START_ALIGN. */
enum glide_result glide_memory_required(uint32 levels, const struct glide_texture *texture,
                                        uint32 *bytes);

/* Sets the map to draw from. levels: the levels that are in memory from start on. A unit that does
   not hold a level draws from the next smaller one, so the map must have that too. */
enum glide_result glide_source(struct glide *glide, uint32 start, uint32 levels,
                               const struct glide_texture *texture);

/* Copy texels to memory. glide_download takes the texels of all levels from the largest to the
   smallest, one after the other, and copies the levels that `levels` names. The others take those
   of one level, or of some of its rows. Texels are uint8 or uint16, row by row, without gaps. */
enum glide_result glide_download(struct glide *glide, uint32 start, uint32 levels,
                                 const struct glide_texture *texture, const void *texels);
enum glide_result glide_download_level(struct glide *glide, uint32 start, uint32 levels,
                                       const struct glide_texture *texture, uint32 level,
                                       const void *texels);
enum glide_result glide_download_rows(struct glide *glide, uint32 start, uint32 levels,
                                      const struct glide_texture *texture, uint32 level,
                                      uint32 first, uint32 last, const void *texels);

/* Sets palette entries first to last: 00RRGGBB. */
enum glide_result glide_palette(struct glide *glide, uint32 first, uint32 last, const uint32 *entries);

/* Set one of the two tables, as values or as its 12 registers: 4 of Y, each 4 bytes, lowest first;
   4 of I and 4 of Q: R 26:18, G 17:9, B 8:0. glide_ncc_select: selects the table to use. */
enum glide_result glide_ncc(struct glide *glide, uint32 table, const struct glide_ncc *values);
enum glide_result glide_ncc_registers(struct glide *glide, uint32 table, const uint32 *registers);
enum glide_result glide_ncc_select(struct glide *glide, uint32 table);

enum glide_result glide_filter(struct glide *glide, uint32 minify, uint32 magnify);
enum glide_result glide_fraction_bits(struct glide *glide, uint32 bits);

/* by_table: 0 or 1. In polygons exact quotients are faster. */
enum glide_result glide_quotients(struct glide *glide, uint32 by_table);

/* dithered: 0 or 1. unit.h describes the polygons that it changes. */
enum glide_result glide_bilinear_by(struct glide *glide, uint32 dithered);

/* Sets how often s and t of polygons are divided by w: 0, at each pixel, or only every 8 or 16
   pixels. A line's pixels, as clipped by the frame, are counted from its first one, and pieces
   begin at 0, `pixels`, 2 `pixels`, ... At a piece's first pixel and at the next piece's, or in the
   line's last piece at its last pixel, s and t are the exact quotients of 32 bits by all rules for
   w. Pixel i of the piece has first + i * step, step = (next - first) over the pixels between them,
   rounded down, all modulo 2^32. So w outside the line is not used. A pixel's level still depends
   on its own w. Units with quotients by the table divide at each pixel, and so do all units in a
   row if one of them dithers its level. Nothing is divided if w is the same at all corners.

   Error: let w and W at a piece's ends have the same sign, r = sqrt(W / w), and no quotient be
   clamped to 32 bits. Then s is off by up to |next - first| * |r - 1| / (r + 1), the distance of
   u r^2 / (1 + u (r^2 - 1)) from u at u = 1 / (r + 1). Rounding down quotients and steps adds up to
   `pixels` * 2^-18 downwards. */
enum glide_result glide_subdivision(struct glide *glide, uint32 pixels);
enum glide_result glide_clamp(struct glide *glide, uint32 s, uint32 t);

/* Without mipmaps only the map's largest level is drawn. lod_blend: for trilinear filtering. */
enum glide_result glide_mipmap(struct glide *glide, uint32 mode, uint32 lod_blend);

/* Sets which levels of a whole map trilinear filtering draws: even or odd ones, for a pass each. */
enum glide_result glide_blend_levels(struct glide *glide, uint32 levels);

/* bias: 16.16, -8.0 to 7.75. As in Glide, an eighth is added, then it is cut to quarters towards
   0. */
enum glide_result glide_lod_bias(struct glide *glide, fix16 bias);

/* Sets the detail factor: (bias - LOD) << scale, clamped to 0 to max / 256. */
enum glide_result glide_detail(struct glide *glide, int32 bias, uint32 scale, uint32 max);

/* Sets functions and factors of colour and alpha. Results are inverted if their flag is 1. */
enum glide_result glide_combine(struct glide *glide, uint32 rgb_function, uint32 rgb_factor,
                                uint32 alpha_function, uint32 alpha_factor, uint32 invert_rgb,
                                uint32 invert_alpha);

/* on: 1 to divide s and t by w. clamp_negative_w: 1 to set both to 0 if w is negative. */
enum glide_result glide_perspective(struct glide *glide, uint32 on, uint32 clamp_negative_w);

/* Set or get the modes as registers: textureMode, tLOD, tDetail, texBaseAddr. Bit 31 of
   textureMode concerns only downloads and is ignored. glide_mipmap still uses the levels of the
   last glide_source. */
enum glide_result glide_registers(struct glide *glide, uint32 mode, uint32 lod, uint32 detail,
                                  uint32 base);
void glide_registers_of(const struct glide *glide, uint32 *registers);

/* Returns a short text for a result, such as "no such format". */
const char *glide_result_text(enum glide_result result);

/* modes.c: copies modes to the unit; increments mode_generation if they differed. */
void glide_set_modes(struct glide *glide, const struct glide_modes *modes);

#endif
