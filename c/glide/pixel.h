/* A pixel of one texture unit, step by step, and of units in a row. */
#ifndef GLIDE_PIXEL_H
#define GLIDE_PIXEL_H

#include "glide/glide.h"

/* Iterated values of a pixel. */
struct glide_point {
    int32 s, t;                 /* 14.18; under perspective s/w and t/w */
    int32 w;                    /* 1/w, 2.30 */
    int32 lod;                  /* glide_lod_base of the polygon */
    int32 x, y;                 /* its place in the frame, only for the LOD's dither */
};

struct glide_lod {
    int32 value;                /* 8.8 */
    uint8 level;                /* the level to draw from */
    uint8 odd;                  /* 1: the integer part of value is odd */
    uint8 filter;               /* enum glide_filtering */
};

struct glide_level {
    uint32 address, columns, rows;
};

/* Units in a row. */
struct glide_chain {
    struct glide *units[GLIDE_UNITS];   /* 0 is nearest the pixel, the last has nothing upstream */
    uint32 count;
    uint32 own;                 /* bit n: unit n has separate points, else it uses unit 0's */
};

/* coordinates.c: calculates point->s * 2^30 / point->w, and likewise t, rounded down and clamped to
   32 bits; w = 0 gives 0. Quotients are exact, or use a reciprocal of w interpolated linearly
   between two of 513 entries, as in the reference data. The reciprocal's relative error is at most
   2^-17 + 2^-20 upwards and 2^-20 downwards. */
void glide_project(const struct glide *glide, const struct glide_point *point, int32 *s, int32 *t);
int32 glide_table_quotient(int32 s, int32 w);

/* logarithm.c: returns 256 log2 of a number of 64 bits, not 0, rounded to the nearest. Bits below
   its 32 highest are ignored. */
int32 glide_logarithm(uint32 hi, uint32 lo);

/* lod.c: return the polygon's LOD, from gradients a pixel (14.18), and find a pixel's. */
int32 glide_lod_base(int32 dsdx, int32 dtdx, int32 dsdy, int32 dtdy);
void glide_find_lod(const struct glide *glide, const struct glide_point *point, struct glide_lod *lod);

/* lod.c: glide_lod_least and glide_lod_most return the limits of LODs; if they cross, the upper
   limit applies. glide_lod_at fills *lod from a LOD that is clamped already. glide_dither returns
   the value that dithering adds to a pixel's LOD, 0.0 to 15/16. */
int32 glide_lod_least(const struct glide_modes *modes);
int32 glide_lod_most(const struct glide_modes *modes);
void glide_lod_at(const struct glide_modes *modes, int32 value, struct glide_lod *lod);
int32 glide_dither(int32 x, int32 y);

/* levels.c: glide_find_level finds a level's address and size; glide_holds returns non-zero if the
   modes' map has the level. */
void glide_find_level(const struct glide_modes *modes, uint32 level, struct glide_level *to);
int32 glide_holds(const struct glide_modes *modes, uint32 level);

/* Returns the bytes in memory of the map's levels before this one. */
uint32 glide_level_offset(const struct glide_modes *modes, uint32 level);

/* texel.c: returns a texel's A R G B. texel: its byte, or both bytes of a 16-bit one. */
uint32 glide_colour(const struct glide *glide, uint32 texel);

/* texel.c: returns texel (i, j), inside the level, as A R G B. */
uint32 glide_texel(const struct glide *glide, const struct glide_level *level, uint32 i, uint32 j);

/* filter.c: returns the unit's own colour at s, t (14.18). */
uint32 glide_sample(const struct glide *glide, const struct glide_lod *lod, int32 s, int32 t);

/* combine.c: returns the detail factor at a LOD. */
int32 glide_detail_factor(const struct glide_modes *modes, int32 lod);

/* combine.c: returns the A R G B combined from the unit's own colour and the one from upstream. */
uint32 glide_combine_pixel(const struct glide *glide, const struct glide_lod *lod, uint32 local,
                           uint32 other);

/* pixel.c: returns a unit's pixel, all steps together. */
uint32 glide_pixel(const struct glide *glide, const struct glide_point *point, uint32 other);

/* The same with known s and t of the pixel (14.18). */
uint32 glide_pixel_at(const struct glide *glide, const struct glide_point *point, int32 s, int32 t,
                      uint32 other);

/* pixel.c: glide_chain_init puts units in a row that all use unit 0's points; glide_chain_hints
   sets which units have separate ones. */
enum glide_result glide_chain_init(struct glide_chain *chain, struct glide *const *units, uint32 count);
enum glide_result glide_chain_hints(struct glide_chain *chain, uint32 own);

/* Returns the pixel of a chain. points: one for each unit; of units without separate points only
   unit 0's is used. */
uint32 glide_chain_pixel(const struct glide_chain *chain, const struct glide_point *points);

#endif
