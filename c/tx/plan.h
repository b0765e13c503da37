/* The passes that draw a polygon's lines. */
#ifndef TX_PLAN_H
#define TX_PLAN_H

#include "tx/forms.h"
#include "tx/lower.h"
#include "tx/planes.h"

typedef void tx_pass(const void *in, void *out, const void *constants, int32 count);

/* Coordinates to one tile's texels. */
struct tx_sampling {
    tx_pass *relative;          /* 0: coordinates are relative to the tile already */
    struct tx_axes axes;
    tx_pass *sample;
    const struct tx_decoded *tile;
    const struct tx_decoded *chroma;    /* YUV's where it is sampled apart, or 0 */
};

/* How the two texels of YUV tiles come about. */
struct tx_yuv {
    int32 on;
    uint8 needed[2], converted[2];      /* of texel 0 and 1: 1 where they are */
    uint8 tile[2];              /* whose sample each is: T0's (0) or T1's */
    uint8 sampled[2];           /* of T0 and T1 */
    struct tx_yuv_conversion conversion;    /* but for its chroma */
};

/* A line's samples of one tile: luma, the last byte of each, and chroma, the first two. */
struct tx_yuv_line {
    uint32 luma[TX_LINE_PIXELS], chroma[TX_LINE_PIXELS];
};

struct tx_plan {
    struct tx_unit *unit;
    const struct tx_planes *planes;
    tx_pass *coordinates;
    union {
        struct tx_iterators walk;
        struct tx_division division;
        struct tx_lod_steps lod;
    } steps;
    int32 levels;               /* each pixel has tiles and a fraction of its own */
    int32 tile0, tile1;         /* where it has not */
    int32 second_texel;         /* texel 1 is needed */
    struct tx_sampling tiles[TX_TILES];
    struct tx_form form;
    uint32 shade;               /* R G B A, where it is the same everywhere */
    const uint8 *tables;        /* TX_SECOND_TABLES: 256 of R, G, B, A each */
    struct tx_yuv yuv;
    int32 is_direct;            /* texels are the colours, and a pass makes 16-bit pixels */
};

/* Finds the passes for a polygon; 0: there are none for these modes or tiles, or memory is
   short. */
int32 tx_plan_find(struct tx_plan *plan, const struct tx_needs *needs, struct tx_unit *unit,
                   const struct tx_planes *planes);

/* yuv.c. What is special about YUV tiles; 0: there are no passes. plan->form may become less
   special. */
int32 tx_yuv_find(struct tx_plan *plan, uint32 inputs);

/* yuv.c. The one texel that the form is of, to colours. from: of T0 and T1. */
void tx_yuv_colours(const struct tx_plan *plan, const struct tx_yuv_line *from, uint32 *colours,
                    int32 count);

/* yuv.c. Texel 0 or 1 as an input of the combiner. */
void tx_yuv_widen(const struct tx_plan *plan, const struct tx_yuv_line *from, int32 texel,
                  struct tx_wide *wide, int32 count);

/* line.c. Where blendings of levels go. */
struct tx_blending *tx_line_blendings(void);

/* line.c. Draws pixels x to x + count - 1 of line y. */
void tx_plan_draw(const struct tx_plan *plan, const struct frame *frame, int32 x, int32 y,
                  int32 count);

/* draw.c. Draws a line pixel by pixel, whatever the modes are. constant: the shade where the planes
   have none. */
void tx_draw_line(const struct tx *tx, const struct tx_planes *planes,
                  const struct tx_colour *constant, const struct frame *frame, int32 x,
                  int32 end, int32 y);

#endif
