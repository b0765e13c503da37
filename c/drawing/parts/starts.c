/* Gradients of the longest scanline, and starts where the edge crosses the line. */
#include "drawing/plan.h"
#include "drawing/three.h"
#include "drawing/ways.h"

/* Sets the steps of spans and of lines. */
static void set_steps(struct setup *s)
{
    const struct texturing *t = &s->texturing;
    const int32 subtexel = s->material->start == START_SUBTEXEL;

    s->span.dudx = t->dudx;
    s->span.dvdx = t->dvdx;
    s->edges.dudx = subtexel ? t->dudx : 0;
    s->edges.dvdx = subtexel ? t->dvdx : 0;
}

enum polygon_result starts_find(struct setup *s)
{
    const struct material *m = s->material;
    struct texturing *t = &s->texturing;

    if (m->gradients == GRADIENTS_PLANE) {
        texturing_crossings(t, s->edges.left, s->edges.lefts);
    } else if (s->count == 3) {
        plan_set_cuts(t, m->mapper);
        texturing_longest(t, &s->sides, &s->box, plan_chain(s));
        (m->start == START_SUBTEXEL ? texturing_pixels : texturing_edges)(
            t, s->edges.left, s->edges.lefts, s->box.right - s->box.left);
    } else {
        return POLYGON_NO_TRIANGLE;
    }
    set_steps(s);
    return POLYGON_DRAWN;
}

void three_starts(struct three *three)
{
    struct setup *s = &three->s;
    struct texturing *t = &s->texturing;

    if (s->material->start == START_SUBTEXEL) {
        texturing_longest(t, &s->sides, &s->box,
                          three->way == THREE_SHADES ? CHAIN_NONE : CHAIN_ANYWHERE);
        texturing_pixels(t, s->edges.left, s->edges.lefts, s->box.right - s->box.left);
    } else {
        texturing_crossings(t, s->edges.left, s->edges.lefts);
    }
    set_steps(s);
}
