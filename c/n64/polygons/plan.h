/* The passes that draw a polygon's lines. */
#ifndef N64_PLAN_H
#define N64_PLAN_H

#include "n64/polygons/forms.h"
#include "n64/polygons/lower.h"
#include "span/scanline.h"
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
    int32 shift;                /* of coordinates to the right, if they need no more; or -1 */
    uint32 fractions;           /* the bits of s:t, then, that are fractions */
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

/* A pass of a line, and what it is called with. in, out: null for the line's pixels. In this order in memory. */
struct n64_stage {
    const void *in;
    void *out;
    const void *constants;
    n64_pass *pass;
};

enum n64_stage_constants { N64_STAGES_MAX = 24, N64_INTERPOLANTS = 7,
    N64_TOGETHER = 32           /* pixels of the longest lines that are drawn together */
};

/* The passes of a polygon's lines, and where the lines begin. */
struct n64_stages {
    const struct plane *planes;
    int32 column;               /* where the planes begin */
    uint16 last_interpolant;    /* number of the last plane that the passes take, from N64_S on */
    uint16 last_stage;          /* and of the last pass */
    uint16 by_line;             /* passes that read iterators: the first ones */
    uint16 joins;               /* 1: only they need lines one by one */
    uint32 starts[N64_INTERPOLANTS];    /* their values in that column of the line to draw */
    uint32 at[N64_INTERPOLANTS];        /* at the first pixel: n64_iterators, then n64_shades */
    uint8 *pixels;              /* of the line to draw: column 0 */
    int32 pitch, pixel_bits;    /* bytes to the next line; log2 of a pixel's */
    struct n64_stage of[N64_STAGES_MAX];
};

struct n64_plan;
typedef void n64_runs(const struct n64_plan *plan, void *out, int32 count);

/* What n64_in_c calls. */
struct n64_in_c {
    n64_runs *routine;
    const struct n64_plan *plan;
};

/* What a plan was made for. */
struct n64_plan_key {
    uint32 state;               /* the sum of generations; 0: no plan is made */
    uint32 inputs, shade;
    int32 divided, pixel_bytes;
    const void *room;
};

/* Kept until the key changes; only planes and steps are each polygon's. */
struct n64_plan {
    struct n64_plan_key key;
    union n64_scratch *scratch;
    struct n64_unit *unit;
    const struct n64_planes *planes;
    n64_pass *coordinates;
    union {
        struct n64_iterators walk;
        struct n64_division division;
        struct n64_lod_steps lod;
    } steps;
    struct n64_shades shade_steps;
    int32 shaded;
    int32 levels;               /* tiles and fraction change from pixel to pixel */
    int32 tile0, tile1;         /* if they do not */
    int32 second_texel;         /* texel 1 is needed */
    struct n64_sampling tiles[N64_TILES];
    struct n64_form form;
    uint32 shade;               /* R G B A, if it is constant */
    const uint32 *tables;       /* N64_SECOND_TABLES: of each value of the channels, R G B A */
    int32 is_intensity;         /* one channel is sampled for all four */
    struct n64_yuv yuv;
    int32 only_blends;          /* levels' fractions are a blend's alone: see n64_level_modes */
    int32 is_direct;            /* texels are the colours: one pass makes 16-bit pixels */
    /* What stages are called with. */
    struct n64_blend blend;
    struct n64_modulation modulation, product;
    struct n64_intensities intensities;
    struct n64_yuv_filter yuv_filter;
    struct n64_yuv_conversion conversions[2];   /* of texel 0 and 1; [0] also the form's one */
    struct n64_combiner_plan combiner;
    struct n64_level_tile level_tiles[N64_TILES];
    struct n64_level_sampling level_samplings[2];   /* of texel 0 and 1 */
    struct n64_in_c in_c;
    struct n64_stages stages;
    struct n64_stage *walked[2];    /* that make coordinates of single lines relative to a tile */
    int32 walked_count;
};

/* Returns the unit's plan with the passes for a polygon; null: there are none for these modes or
   tiles, or memory is short. room: the renderer's, for the plan too. */
struct n64_plan *n64_plan_find(const struct n64_needs *needs, struct n64_unit *unit,
                               const struct n64_planes *planes, int32 pixel_bytes, uint32 *room);

/* plan.c. Sets the planes of S and T, with which a plan whose coordinates are n64_walk needs no others. */
void n64_plan_walk(struct n64_plan *plan, const struct n64_planes *planes);

/* yuv.c. Finds plan->yuv; returns 0 if there are no passes. May set plan->form.any. */
int32 n64_yuv_find(struct n64_plan *plan, uint32 inputs);

/* yuv.c. Makes the colours of a channel's numbers 0 to count - 1 (9 bits, from 384 on negative)
   after the form's second part. */
void n64_form_colours(const struct n64_plan *plan, uint32 *colours, int32 count);

/* yuv.c. Sets a conversion of texel 0 or 1. from: the lines of T0 and T1. Returns the luma. */
const uint32 *n64_yuv_conversion_set(struct n64_yuv_conversion *conversion,
                                     const struct n64_plan *plan,
                                     const struct n64_yuv_line *from, int32 texel);

/* runs.c. Of pixels whose levels differ: texels, blended or multiplied as the form says; the
   samples of YUV, to two n64_yuv_line; texels as 16-bit pixels. */
n64_runs n64_runs_texels, n64_runs_yuv, n64_runs_direct;

/* stages.c. Lists a plan's passes. */
void n64_stages_find(struct n64_plan *plan, int32 pixel_bytes);

/* stages.c. Draws lines: rows of the table, from line y of the frame on; none has more than `width` pixels. */
void n64_plan_draw(struct n64_plan *plan, const struct frame *frame, const struct scanline *lines,
                   int32 y, int32 rows, int32 width);

/* src68k/n64: contracts there. */
void n64_stages_draw(struct n64_stages *stages, const struct scanline *lines, int32 rows);
void n64_stages_together(struct n64_stages *stages, const struct scanline *lines, int32 rows, uint32 *room);

/* draw.c. Draws pixels x to end - 1 of line y one by one, in all modes. constant: the shade if the
   planes have none. */
void n64_draw_line(const struct n64 *n64, const struct n64_planes *planes,
                   const struct n64_colour *constant, const struct frame *frame, int32 x,
                   int32 end, int32 y);

#endif
