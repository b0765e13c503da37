/* The passes that draw a polygon's lines. */
#ifndef N64_PLAN_H
#define N64_PLAN_H

#include "n64/polygons/forms.h"
#include "n64/polygons/lower.h"
#include "polygon/planes.h"

enum n64_interpolant { N64_S, N64_T, N64_W, N64_RED, N64_GREEN, N64_BLUE, N64_ALPHA };

#define N64_W_ONE 0x7fff0000    /* the greatest w: 1.0 */

/* Planes of what is interpolated over a polygon, s15.16, by enum n64_interpolant. */
struct n64_planes {
    struct planes all;
    int32 divided;              /* s and t must be divided by w */
    int32 shaded;
};

/* The passes from coordinates to one tile's texels. */
struct n64_sampling {
    n64_pass *relative;         /* 0: coordinates are relative to the tile already */
    struct n64_axes axes;
    n64_pass *sample;
    const struct n64_decoded *tile;
    const struct n64_decoded *chroma;   /* YUV's, if it is sampled separately, or null */
};

/* How the two texels of YUV tiles are made. */
struct n64_yuv {
    int32 on;
    uint8 needed[2], converted[2];      /* texel 0, texel 1: 1 if so */
    uint8 tile[2];              /* sampled from T0 (0) or T1 (1) */
    uint8 sampled[2];           /* T0, T1: 1 if so */
    struct n64_yuv_conversion conversion;   /* without chroma */
};

struct n64_plan {
    union n64_scratch *scratch;
    struct n64_unit *unit;
    const struct n64_planes *planes;
    n64_pass *coordinates;
    union {
        struct n64_iterators walk;
        struct n64_division division;
        struct n64_lod_steps lod;
    } steps;
    int32 levels;               /* tiles and fraction change from pixel to pixel */
    int32 tile0, tile1;         /* if they do not */
    int32 second_texel;         /* texel 1 is needed */
    struct n64_sampling tiles[N64_TILES];
    struct n64_form form;
    uint32 shade;               /* R G B A, if it is constant */
    const uint8 *tables;        /* N64_SECOND_TABLES: 256 of R, G, B, A each */
    struct n64_yuv yuv;
    int32 is_direct;            /* texels are the colours: one pass makes 16-bit pixels */
};

/* Finds the passes for a polygon; 0: there are none for these modes or tiles, or memory is
   short. room: the renderer's, for the plan too. */
int32 n64_plan_find(struct n64_plan *plan, const struct n64_needs *needs, struct n64_unit *unit,
                    const struct n64_planes *planes, uint32 *room);

/* yuv.c. Finds plan->yuv; returns 0 if there are no passes. May set plan->form.any. */
int32 n64_yuv_find(struct n64_plan *plan, uint32 inputs);

/* yuv.c. Makes the colours of a channel's numbers 0 to count - 1 (9 bits, from 384 on negative)
   after the form's second part. */
void n64_form_colours(const struct n64_plan *plan, uint32 *colours, int32 count);

/* yuv.c. Converts the form's one texel to colours. from: the lines of T0 and T1. */
void n64_yuv_colours(const struct n64_plan *plan, const struct n64_yuv_line *from, uint32 *colours,
                     int32 count);

/* yuv.c. Converts texel 0 or 1 to an input of the combiner. */
void n64_yuv_widen(const struct n64_plan *plan, const struct n64_yuv_line *from, int32 texel,
                   struct n64_wide *wide, int32 count);

/* line.c. Draws pixels x to x + count - 1 of line y. */
void n64_plan_draw(const struct n64_plan *plan, const struct frame *frame, int32 x, int32 y,
                   int32 count);

/* draw.c. Draws pixels x to end - 1 of line y one by one, in all modes. constant: the shade if the
   planes have none. */
void n64_draw_line(const struct n64 *n64, const struct n64_planes *planes,
                   const struct n64_colour *constant, const struct frame *frame, int32 x,
                   int32 end, int32 y);

#endif
