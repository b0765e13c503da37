/* The state of a polygon in the set-up; the rules of lowering read it. */
#ifndef SETUP_H
#define SETUP_H

#include "polygon/edges.h"
#include "polygon/polygon.h"
#include "polygon/scratch.h"
#include "polygon/sides.h"
#include "polygon/texturing.h"
#include "span/perspective.h"
#include "span/scanline.h"

/* How far x of an edge may be beyond its vertices, pixels, 16.16. Its start and steps are within
   1/2^17 each: at most 0.008 over the 1,024 lines of a frame. */
enum { EDGE_ERROR = 1024 };

/* What of a polygon has a depth that hardly changes. Columns are drawn as the lines of a frame with x and y
   exchanged. */
enum level { LEVEL_NOTHING, LEVEL_LINES, LEVEL_COLUMNS };

struct setup {
    struct renderer *renderer;
    struct scratch *scratch;            /* the renderer's; so are frame and off */
    const struct frame *frame;
    const struct material *material;
    enum form form;
    uint32 off;
    uint32 applied;                     /* bit n: rule n applied */
    struct draw_counts *counts;         /* of the material, or 0 */

    const struct vertex *given;         /* as the caller gave them */
    const struct vertex *vertices;      /* from material_vertices: the whole polygon, for
                                           gradients */
    int32 count;
    enum span_kind kind;                /* the material's, lowered step by step */
    enum span_kind affine;              /* SPAN_PERSPECTIVE: what draws it without; set if the vertices
                                           may lower the kind */
    enum perspective setting;           /* SPAN_PERSPECTIVE: the material's, lowered */
    enum level level;                   /* SPAN_PERSPECTIVE: what is drawn as if it were affine */

    struct sides sides;
    struct rectangle box;               /* the part of the frame that it may cover */
    const struct sides *outline_sides;  /* for edges: sides, or those of the clipped part */
    struct edge_plan edges;
    struct span_plan span;
    struct texturing texturing;         /* not with GRADIENTS_SCANLINE */
    struct perspective_plan *perspective;
};

/* src68k/polygon: contracts there. */
enum polygon_result polygon_find(struct setup *s, int32 exact, int32 chain);
void plane_find(struct setup *s, int32 chain);

/* Sets where edges and lines are made. */
static inline void setup_edges_set(struct setup *s)
{
    s->edges.lines = s->scratch->lines;
    s->edges.left = s->scratch->left;
    s->edges.right = s->scratch->right;
}

/* Sets the fields that the caller gives; not `form`, which texture units do not use. */
static inline void setup_begin(struct setup *s, struct renderer *renderer,
                               const struct polygon *polygon, const struct material *material)
{
    s->renderer = renderer;
    s->scratch = renderer->scratch;
    setup_edges_set(s);
    s->frame = renderer->frame;
    s->material = material;
    s->off = renderer->off;
    s->applied = 0;
    s->counts = renderer->counts ? &renderer->counts[material->number] : 0;
    s->given = polygon->vertices;
    s->count = polygon->count;
}

#endif
