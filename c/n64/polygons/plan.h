/* The passes that draw a polygon's lines. */
#ifndef N64_PLAN_H
#define N64_PLAN_H

#include "n64/polygons/forms.h"
#include "n64/polygons/lower.h"
#include "n64/polygons/planes.h"

typedef void n64_pass(const void *in, void *out, const void *constants, int32 count);

/* Coordinates to one tile's texels. */
struct n64_sampling {
    n64_pass *relative;         /* 0: coordinates are relative to the tile already */
    struct n64_axes axes;
    n64_pass *sample;
    const struct n64_decoded *tile;
    const struct n64_decoded *chroma;   /* YUV's where it is sampled apart, or 0 */
};

/* How the two texels of YUV tiles come about. */
struct n64_yuv {
    int32 on;
    uint8 needed[2], converted[2];      /* of texel 0 and 1: 1 where they are */
    uint8 tile[2];              /* whose sample each is: T0's (0) or T1's */
    uint8 sampled[2];           /* of T0 and T1 */
    struct n64_yuv_conversion conversion;   /* but for its chroma */
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
    int32 levels;               /* each pixel has tiles and a fraction of its own */
    int32 tile0, tile1;         /* where it has not */
    int32 second_texel;         /* texel 1 is needed */
    struct n64_sampling tiles[N64_TILES];
    struct n64_form form;
    uint32 shade;               /* R G B A, where it is the same everywhere */
    const uint8 *tables;        /* N64_SECOND_TABLES: 256 of R, G, B, A each */
    struct n64_yuv yuv;
    int32 is_direct;            /* texels are the colours, and a pass makes 16-bit pixels */
};

/* Finds the passes for a polygon; 0: there are none for these modes or tiles, or memory is
   short. room: the renderer's, for the plan too. */
int32 n64_plan_find(struct n64_plan *plan, const struct n64_needs *needs, struct n64_unit *unit,
                    const struct n64_planes *planes, uint32 *room);

/* yuv.c. What is special about YUV tiles; 0: there are no passes. plan->form may become less
   special. */
int32 n64_yuv_find(struct n64_plan *plan, uint32 inputs);

/* yuv.c. The one texel that the form is of, to colours. from: of T0 and T1. */
void n64_yuv_colours(const struct n64_plan *plan, const struct n64_yuv_line *from, uint32 *colours,
                     int32 count);

/* yuv.c. Texel 0 or 1 as an input of the combiner. */
void n64_yuv_widen(const struct n64_plan *plan, const struct n64_yuv_line *from, int32 texel,
                   struct n64_wide *wide, int32 count);

/* line.c. Draws pixels x to x + count - 1 of line y. */
void n64_plan_draw(const struct n64_plan *plan, const struct frame *frame, int32 x, int32 y,
                   int32 count);

/* draw.c. Draws a line pixel by pixel, whatever the modes are. constant: the shade where the planes
   have none. */
void n64_draw_line(const struct n64 *n64, const struct n64_planes *planes,
                   const struct n64_colour *constant, const struct frame *frame, int32 x,
                   int32 end, int32 y);

#endif
