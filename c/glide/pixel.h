/* A pixel of a texture unit, part by part, and of units in a row. */
#ifndef GLIDE_PIXEL_H
#define GLIDE_PIXEL_H

#include "glide/glide.h"

/* What is iterated for a pixel. */
struct glide_point {
    int32 s, t;                 /* 14.18; under perspective s/w and t/w */
    int32 w;                    /* 1/w, 2.30 */
    int32 lod;                  /* glide_lod_base of the polygon */
    int32 x, y;                 /* its place in the frame, for the LOD's dither alone */
};

struct glide_lod {
    int32 value;                /* 8.8 */
    uint8 level;                /* that is drawn from */
    uint8 odd;                  /* 1: the level that the value stands for is */
    uint8 filter;               /* enum glide_filtering */
};

struct glide_level {
    uint32 address, columns, rows;
};

/* Units in a row. */
struct glide_chain {
    struct glide *units[GLIDE_UNITS];   /* 0 is nearest the pixel, the last has nothing upstream */
    uint32 count;
    uint32 own;                 /* bit n: unit n has points of its own, or else unit 0's */
};

/* coordinates.c: point->s * 2^30 / point->w, and of t, rounded down; what does not fit is the
   least or the greatest number; w = 0: 0. Exact, or through a reciprocal of w that lies on a
   straight line between two of 513 entries: that is up to 2^-17 and 2^-20 of it too large, 2^-20
   too small, and what reference data have. */
void glide_project(const struct glide *glide, const struct glide_point *point, int32 *s, int32 *t);
int32 glide_table_quotient(int32 s, int32 w);

/* logarithm.c: 256 log2 of a number of 64 bits, not 0, rounded to the nearest; bits below its
   32 highest do not count. */
int32 glide_logarithm(uint32 hi, uint32 lo);

/* lod.c: the polygon's LOD, of gradients a pixel (14.18), and the pixel's. */
int32 glide_lod_base(int32 dsdx, int32 dtdx, int32 dsdy, int32 dtdy);
void glide_find_lod(const struct glide *glide, const struct glide_point *point, struct glide_lod *lod);

/* lod.c: what LODs are cut to, where the limits cross the upper one; what stands for a LOD that is
   cut already; what dithering adds to pixels' LODs, 0.0 to 15/16. */
int32 glide_lod_least(const struct glide_modes *modes);
int32 glide_lod_most(const struct glide_modes *modes);
void glide_lod_at(const struct glide_modes *modes, int32 value, struct glide_lod *lod);
int32 glide_dither(int32 x, int32 y);

/* levels.c: a level's place and size; whether the modes' map has it. */
void glide_find_level(const struct glide_modes *modes, uint32 level, struct glide_level *to);
int32 glide_holds(const struct glide_modes *modes, uint32 level);

/* Bytes in memory of the levels before this one that the map has. */
uint32 glide_level_offset(const struct glide_modes *modes, uint32 level);

/* texel.c: a texel's A R G B; both its bytes where it has two. */
uint32 glide_colour(const struct glide *glide, uint32 texel);

/* texel.c: texel (i, j), inside the level, as A R G B. */
uint32 glide_texel(const struct glide *glide, const struct glide_level *level, uint32 i, uint32 j);

/* filter.c: the unit's own colour at s, t (14.18). */
uint32 glide_sample(const struct glide *glide, const struct glide_lod *lod, int32 s, int32 t);

/* combine.c: the detail factor at a LOD. */
int32 glide_detail_factor(const struct glide_modes *modes, int32 lod);

/* combine.c: A R G B of the unit's own colour and of the one from upstream. */
uint32 glide_combine_pixel(const struct glide *glide, const struct glide_lod *lod, uint32 local,
                           uint32 other);

/* pixel.c: all of it. */
uint32 glide_pixel(const struct glide *glide, const struct glide_point *point, uint32 other);

/* The same where s and t of the pixel (14.18) are known. */
uint32 glide_pixel_at(const struct glide *glide, const struct glide_point *point, int32 s, int32 t,
                      uint32 other);

/* chain.c: units in a row, none of them with points of its own; then which have. */
enum glide_result glide_chain_init(struct glide_chain *chain, struct glide *const *units, uint32 count);
enum glide_result glide_chain_hints(struct glide_chain *chain, uint32 own);

/* A point for each unit; those that are not its own are not looked at. */
uint32 glide_chain_pixel(const struct glide_chain *chain, const struct glide_point *points);

#endif
