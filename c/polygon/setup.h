/* The state of a polygon in the set-up, which the rules of lowering read. */
#ifndef SETUP_H
#define SETUP_H

#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "polygon/scratch.h"
#include "polygon/sides.h"
#include "polygon/texturing.h"
#include "span/perspective.h"
#include "span/scanline.h"

/* How far an edge's x may be beyond its vertices, in pixels, 16.16: its start and its steps are
   within 1/2^17, over the 1,024 lines of a frame at most 0.008. */
#define EDGE_ERROR 1024

struct setup {
    struct renderer *renderer;
    struct scratch *scratch;            /* the renderer's, as frame and off */
    const struct frame *frame;
    const struct material *material;
    enum form form;
    uint32 off;
    uint32 applied;                     /* bit n: rule n applied */
    struct draw_counts *counts;         /* of the material, or 0 */

    const struct vertex *given;         /* as the caller gave them */
    const struct vertex *vertices;      /* as material_vertices makes them: the whole polygon,
                                           what gradients come from */
    int32 count;
    enum span_kind kind;                /* what draws it, from what is asked for down */
    enum perspective setting;           /* SPAN_PERSPECTIVE: how, down from the material's */
    int32 straight;                     /* ... each line is, from its first pixel on */

    struct sides sides;
    struct rectangle box;               /* what it may cover of the frame */
    const struct vertex *outline;       /* what edges come from: vertices, or their clipped part */
    int32 outline_count;
    const struct sides *outline_sides;
    struct edge_plan edges;
    struct span_plan span;
    struct texturing texturing;         /* where gradients are of the polygon */
    struct perspective_plan *perspective;
};

/* As the caller gives it; not `form`, which texture units do not ask for. */
static inline void setup_begin(struct setup *s, struct renderer *renderer,
                               const struct polygon *polygon, const struct material *material)
{
    s->renderer = renderer;
    s->scratch = renderer->scratch;
    s->frame = renderer->frame;
    s->material = material;
    s->off = renderer->off;
    s->applied = 0;
    s->counts = renderer->counts ? &renderer->counts[material->number] : 0;
    s->given = polygon->vertices;
    s->count = polygon->count;
}

#endif
