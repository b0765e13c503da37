/* The passes that draw a polygon's lines. */
#ifndef GLIDE_PLAN_H
#define GLIDE_PLAN_H

#include "glide/polygons/combining.h"
#include "glide/polygons/unit.h"
#include "limits.h"
#include "polygon/planes.h"

/* Indices of planes. */
enum glide_iterated {
    GLIDE_S, GLIDE_T, GLIDE_W,
    GLIDE_OWN = 4,              /* the first of the unit with separate points */
    GLIDE_DITHERS = 16
};

/* Values iterated over a polygon. */
struct glide_iterations {
    struct planes planes;
    struct glide_point points[GLIDE_UNITS];     /* lod is the polygon's, the rest each pixel's */
    int32 divided[GLIDE_UNITS];  /* w changes, and a unit divides by it */
    struct glide_range {
        int32 least, most;      /* of W over the polygon's box; least 0: it may be lower */
    } ranges[GLIDE_UNITS];
};

/* Passes to a band's texels, found at its first use. */
struct glide_sampling {
    const struct glide_decoded *level;  /* null before that */
    glide_pass *sample;
    struct glide_steps steps;   /* s, t and w are each run's */
};

/* One unit's part in a polygon. */
struct glide_part {
    struct glide_part *upstream;  /* 0: nothing that counts */
    struct glide_line_scratch *scratch;
    const struct glide_logarithm *logarithms;   /* where LODs are needed */
    const uint8 *products;      /* the middle of their table; null: not needed, or no memory */
    const struct glide *glide;
    struct glide_kept *levels;
    const struct glide_bands *bands;
    const struct glide_iterations *iterations;
    int32 first;                /* plane */
    int32 lod;                  /* the polygon's and the bias */
    int32 by_w;                 /* pixels' LODs depend on their w */
    int32 hides_behind;         /* not divided; coordinates are 0 where w is negative */
    int32 is_one;               /* all its pixels are of one band */
    uint32 band, last;          /* the first and the last that pixels may have */
    uint32 bits, every;         /* bits of any, and of all, bands that pixels may have */
    glide_pass *coordinates;
    int32 piece_bits;           /* of glide_pieces; 0: every pixel is divided, or none */
    uint32 ready;               /* bit n: limits[n] are made */
    /* For pixels whose dither is n / 16: |w| of a band's pixels is below its limit, but not below
       the next band's. */
    uint32 limits[GLIDE_DITHERS][GLIDE_BANDS];
    struct glide_sampling samplings[GLIDE_BANDS];
    /* mips.c: for lines whose pixels have several levels. */
    const struct glide_combining *mixing;  /* of all bands; null: such lines are drawn run by run */
    int32 mixes;                /* by fractions that differ */
    glide_pass *mip_sample;     /* null: mips, and what follows, are not made */
    struct glide_steps mip_steps;
    struct glide_lods mip_lods;  /* lods are a line's if they are dithered */
    struct glide_mip mips[GLIDE_MIPS];
};

struct glide_plan {
    struct glide_line_scratch *scratch;
    struct glide_part parts[GLIDE_UNITS];  /* the first is nearest the pixel */
    int32 is_dithered;
    int32 is_direct;            /* texels are pixels */
    int32 has_mips;             /* lines may be drawn by glide_mips_draw */
};

/* Pixels of one line, from x on: all of them, or every fourth, which have the same dither. */
struct glide_row {
    int32 x, y, step_bits;      /* 0 or 2 */
    int32 count;                /* of the line's pixels; not used if step_bits is 2 */
};

/* Runs of a row's pixels that a unit draws by the same passes. */
struct glide_runs {
    struct glide_part *part;
    struct glide_iterators at, by;      /* the first pixel's, and its steps */
    uint32 band;
    int32 count, left, dither;
    int32 end, line;            /* the row's pixel behind the last one; row->count */
};

/* Returns non-zero if the limits of a unit's levels allow only one LOD, which is then in *lod. */
int32 glide_only_lod(const struct glide *glide, struct glide_lod *lod);

/* Finds the passes for a polygon; 0: there are none for these modes, or memory is short.
   pixel_bytes: of the frame. Reads plan->scratch. */
int32 glide_plan_find(struct glide_plan *plan, struct glide_pipe *pipe,
                      const struct glide_iterations *iterations, int32 pixel_bytes);

/* Finds the passes to a band's texels; returns null if there is no memory. */
struct glide_sampling *glide_sampling_find(struct glide_part *part, uint32 band);

/* Finds a unit's iterators at a pixel. first: its planes. */
static inline void glide_planes_at(const struct planes *planes, int32 first, int32 x, int32 y,
                                   struct glide_iterators *at)
{
    const struct plane *of = &planes->of[first];
    const uint32 right = (uint32)(x - planes->i), down = (uint32)(y - planes->j);

    at->s = (int32)(of[GLIDE_S].at + right * of[GLIDE_S].dx + down * of[GLIDE_S].dy);
    at->t = (int32)(of[GLIDE_T].at + right * of[GLIDE_T].dx + down * of[GLIDE_T].dy);
    at->w = (int32)(of[GLIDE_W].at + right * of[GLIDE_W].dx + down * of[GLIDE_W].dy);
}

static inline void glide_part_at(const struct glide_part *part, int32 x, int32 y,
                                 struct glide_iterators *at)
{
    glide_planes_at(&part->iterations->planes, part->first, x, y, at);
}

/* runs.c. Returns the band of pixels with |w| = size and dither / 16 added to their LODs. */
uint32 glide_runs_band(struct glide_part *part, int32 dither, int32 size);

/* runs.c. Prepares the runs of a unit's pixels `first` to `first` + count - 1 of a row. */
void glide_runs_open(struct glide_runs *runs, struct glide_part *part, const struct glide_row *row,
                     int32 first, int32 count);

/* runs.c. Finds the run behind this one. */
void glide_runs_find(struct glide_runs *runs);

/* Finds the next run; returns 0 if there is none. A new run begins where w passes 0 or wraps. */
static inline int32 glide_runs_next(struct glide_runs *runs)
{
    runs->left -= runs->count;
    if (!runs->left)
        return 0;
    if (runs->part->is_one)
        runs->count = runs->left;
    else
        glide_runs_find(runs);
    return 1;
}

/* runs.c. Sets *mixed to 1 if dithering moves some of a line's next pixels to other bands, else to
   0; returns for how many of `count` pixels this is the same. */
int32 glide_runs_alike(struct glide_plan *plan, int32 x, int32 y, int32 count, int32 *mixed);

/* mips.c. Sets part->mixing and part->mixes. */
void glide_mips_open(struct glide_part *part);

/* mips.c. Draws a line's texels by passes that find each pixel's level, if it is expected to take
   less time than run by run. Returns 0 if the line is not drawn. */
int32 glide_mips_draw(struct glide_plan *plan, const struct glide_row *row, uint32 *to, int32 count);

/* line.c. Sets what is the same for all lines, except w's step if lines have every fourth pixel. */
void glide_lods_open(const struct glide_part *part, struct glide_lods *lods);

/* line.c. Sets the LODs of the pixels from x on; *lods is open. */
void glide_lods_set(const struct glide_part *part, const struct glide_row *row, int32 x,
                    struct glide_lods *lods);

/* Factors from the level of detail: bytes, `step` from pixel to pixel (0: one for all). flip: 255
   if the level is odd and inverts factors. */
struct glide_factors {
    const uint8 *details, *fractions;
    int32 detail_step, fraction_step;
    uint16 flip, spare;
};

/* Sets a band's factors as if they were the same for all pixels. */
static inline void glide_factors_open(struct glide_factors *factors, const struct glide_band *band)
{
    factors->details = &band->detail;
    factors->fractions = &band->fraction;
    factors->detail_step = factors->fraction_step = 0;
    factors->flip = band->flip;
}

/* combine_line.c. Combines a line of local and other texels, R G B A; other: null if nothing is
   upstream. `to` must differ from both. */
void glide_combine_line(const struct glide_combining *combining, const struct glide_modes *modes,
                        const struct glide_factors *factors, const uint32 *local,
                        const uint32 *other, uint32 *to, int32 count);

/* src68k/glide: draw the lines; the second one those that have `joins`, if all pixels have room. */
void glide_lines(struct glide_lines *lines);
void glide_lines_together(struct glide_lines *lines, uint32 *room);

/* lines.c. Adds a pass whose data is `bytes` long. */
void glide_lines_add(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                     const void *constants, uint32 bytes);

/* Adds a pass whose data stays where it is. */
void glide_lines_stage(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                       const void *constants);

/* line.c. Returns non-zero if a band's texels are multiplied as they are filtered: by *times, then. */
int32 glide_part_times(const struct glide_part *part, uint32 band, const uint32 *other, struct glide_times *times);

/* combine_line.c. Adds the passes of glide_combine_line. to: null if it is the frame. */
void glide_combine_add(struct glide_lines *lines, const struct glide_combining *combining,
                       const struct glide_modes *modes, const struct glide_factors *factors,
                       const uint32 *local, const uint32 *other, uint32 *to);

/* lines.c. Finds the passes of all lines, pipe->lines; returns 0 if lines do not have the same ones.
   glide_lines_kept returns non-zero if these are there already: units whose pixels all have one LOD's
   passes keep them until their state changes. */
int32 glide_lines_find(struct glide_pipe *pipe, struct glide_plan *plan, const struct setup *s);
int32 glide_lines_kept(const struct glide_pipe *pipe, const struct glide_iterations *at,
                       const struct setup *s);

/* lines.c. Draws a polygon's lines, 1 or more, by passes that are found. */
void glide_lines_draw(struct glide_lines *lines, const struct planes *planes, const struct setup *s,
                      struct glide_line_scratch *work);

/* The same without own points, where w is the same in all corners: finds the planes of s and t too. */
void glide_lines_draw_level(struct glide_lines *lines, const struct setup *s, struct glide_line_scratch *work);

/* pixels.c. Returns the bits of a unit's pieces of 2^bits pixels (glide_subdivision), or 0 if it
   divides each pixel or none. */
int32 glide_piece_bits(const struct glide_chain *chain, uint32 unit);

/* pixels.c. Draws pixels x to end - 1 of line y one by one; at->points holds each one's values. */
void glide_pixels_draw(const struct glide_pipe *pipe, struct glide_iterations *at,
                       const struct frame *frame, int32 x, int32 end, int32 y);

typedef int32 glide_plan_routine(struct glide_plan *plan, const struct frame *frame, int32 x, int32 y,
                                 int32 count);

/* line.c. Draws pixels x to x + count - 1 of line y. Returns 0 if some have no passes or there is
   no memory: the caller must then draw them all. */
glide_plan_routine glide_plan_draw;

/* line.c. Adds the pixels to the frame (glide_pipe_adds). If it returns 0, nothing was added. */
glide_plan_routine glide_plan_add;

#endif
