/* The passes that draw a polygon's lines. */
#ifndef TMU_PLAN_H
#define TMU_PLAN_H

#include "polygon/planes.h"
#include "scene/scene_file.h"
#include "tmu/combining.h"
#include "tmu/unit.h"

/* Numbers of planes. */
enum tmu_iterated {
    TMU_S, TMU_T, TMU_W,
    TMU_OWN = 4                 /* the first of the unit with points of its own */
};

/* What is iterated over a polygon. */
struct tmu_iterations {
    struct planes planes;
    struct tmu_point points[TMU_UNITS];         /* their LOD; pixels differ in the rest */
    int32 divided[TMU_UNITS];   /* w changes, and a unit divides by it */
};

typedef void tmu_pass(const void *in, void *out, const void *constants, int32 count);

/* One unit's texels, and what becomes of them. */
struct tmu_sampling {
    int32 first;                /* plane */
    struct tmu_lod lod;
    tmu_pass *coordinates, *sample;
    struct tmu_steps steps;
    const struct tmu_decoded *level;
    struct tmu_combining combining;
};

struct tmu_plan {
    const struct tmu_pipe *pipe;
    const struct planes *planes;
    struct tmu_sampling units[TMU_UNITS];
    uint32 first, last;         /* the units furthest upstream and downstream that count */
    int32 is_direct;            /* a pass makes 16-bit pixels of coordinates */
};

/* The LOD of all pixels where the limits of a unit's levels leave one only; 0: they leave
   several. */
int32 tmu_only_lod(const struct tmu *tmu, struct tmu_lod *lod);

/* Finds the passes for a polygon; 0: there are none for these modes, or memory is short.
   pixel_bytes: of the frame. */
int32 tmu_plan_find(struct tmu_plan *plan, struct tmu_pipe *pipe,
                    const struct tmu_iterations *iterations, int32 pixel_bytes);

/* Factors that come from the level of detail: bytes, `step` from pixel to pixel (0: one for all);
   flip: 255 where odd levels turn them round. */
struct tmu_factors {
    const uint8 *details, *fractions;
    int32 detail_step, fraction_step;
    uint16 flip, spare;
};

/* combine_line.c. Makes a line of local and other texels, R G B A; other: 0 where there is nothing
   upstream. `to` is neither. */
void tmu_combine_line(const struct tmu_combining *combining, const struct tmu_modes *modes,
                      const struct tmu_factors *factors, const uint32 *local,
                      const uint32 *other, uint32 *to, int32 count);

/* line.c. The memory that lines are drawn in, made when it is first asked for; 0: there is none. */
int32 tmu_line_ready(void);

/* line.c. Draws pixels x to x + count - 1 of line y. */
void tmu_plan_draw(const struct tmu_plan *plan, const struct frame *frame, int32 x, int32 y,
                   int32 count);

#endif
