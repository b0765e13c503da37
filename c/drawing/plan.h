/* From a convex polygon to its scanline table and the call that draws it. With gradients of the plane and sub-
   texel starts, all numbers that decide a pixel are functions of the pixel alone: x of an edge at line j is x0 +
   (j - j0) slope, where j0 is its first line in the frame; u at pixel (i, j) is u_ref + (i - i_ref) dudx + (j -
   j_ref) dudy modulo 2^32, (i_ref, j_ref) being the first pixel right of the left side, or the middle of the box
   if gradients are steep. So it does not matter which vertex comes first, an edge from far above has not drifted
   when it reaches the frame, and polygons that share an edge leave no gap. The model in tools/tmap/model/model.py
   does the same arithmetic. */
#ifndef DRAWING_PLAN_H
#define DRAWING_PLAN_H

#include "polygon/clip.h"
#include "polygon/ramps.h"
#include "polygon/scratch.h"
#include "polygon/setup.h"

/* Uses of the scratch room by polygons without perspective, one at a time. */
union plan_made {
    struct made_ramps {
        struct ramp left[CLIP_VERTICES_MAX], right[CLIP_VERTICES_MAX];
        struct scanline_step steps[FRAME_SIDE_MAX];
    } ramps;
    uint32 shades[FRAME_SIDE_MAX];
    uint8 code[CODE_BYTES + CACHE_BYTES];
};

SCRATCH_FITS(union plan_made);

static inline union plan_made *plan_room(const struct setup *s)
{
    return (union plan_made *)s->scratch->room;
}

static inline int32 plan_is_flat(const struct setup *s)
{
    return s->kind <= SPAN_FILL_32;
}

/* Sets the number of low bits of u and v that the mapper's spans do not keep. */
static inline void plan_set_cuts(struct texturing *t, enum mapper mapper)
{
    t->u_cut = mapper == MAPPER_COLUMNS ? (uint32)CUT_COLUMNS : 0;
    t->v_cut = mapper == MAPPER_TILED ? (uint32)CUT_TILED_V : t->u_cut;
}

/* Returns how u and v of the polygon's spans share an addx chain. */
enum chain plan_chain(const struct setup *s);

/* Finds the plane of a polygon that has its outline. Materials of texture units have the units' plane,
   to the last bit. */
void plan_set_plane(struct setup *s);

/* Finds the outline of the given polygon and sets its span. */
enum polygon_result plan_set_up(struct setup *s);

#endif
