#include "drawing/dithered.h"

enum {
    MOST = 3 * 65536 / 8,       /* texels; the most that a point is moved in either direction */
    PERIOD = 65536              /* 256 texels in 8.8 */
};

/* Returns how far a step moves v over half of the box's pixels, 8.8, rounded up; PERIOD if the step
   is too large. */
static uint32 travel(fix16 step, int32 pixels)
{
    const uint32 slope = (step < 0 ? 0 - (uint32)step : (uint32)step) >> 8;

    return slope < PERIOD ? (slope + 1) * (uint32)((pixels + 1) >> 1) : PERIOD;
}

void dithered_span(struct setup *s)
{
    struct texturing *t = &s->texturing;
    struct edge *edge = s->edges.left;
    const uint32 v = texturing_middle(t, &s->box) >> 8 & (PERIOD - 1);
    const uint32 far = travel(t->dvdx, s->box.right - s->box.left)
        + travel(t->dvdy, s->box.bottom - s->box.top) + MOST / 256 + 1;

    t->wraps = v < far || v + far >= PERIOD;
    s->span.odd = s->box.top & 1;
    for (int32 i = s->edges.lefts; i > 0; i--, edge++) {
        edge->u -= MOST;
        edge->v -= MOST;
    }
}
