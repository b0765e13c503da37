#include "polygon/shading.h"

#include "math/math.h"
#include "polygon/texturing.h"

/* Spans keep the lowest bits of a level's fraction for wraps of v. */
#define FREE_BITS ((1 << CUT_LEVEL) - 1)

/* INSET: how far a pixel's level on the stepped plane may be outside the vertices' range. A pixel
   is within 1/64 pixel of the polygon, and clipped vertices add as much; each times at most one
   level a pixel. */
#define INSET (65536 / 16)
#define STEEP_1 65536

int32 shading_light(struct span_plan *span, const struct material *material, fix16 shade)
{
    if (!material->light || material->light->layout != MAP_LIGHT)
        return 0;
    span->light = material->light->texels;
    span->light += 256 * (shade >> LEVEL_BITS);
    return 1;
}

/* Copies a corner with its level as s; returns to. */
static const struct vertex *lit(struct vertex *to, const struct vertex *from)
{
    to->x = from->x;
    to->y = from->y;
    to->s = SHADE_LEVEL(from->shade);
    to->t = 0;
    return to;
}

/* Returns 1 if no pixel leaves the range, judged by the stepped plane at the vertices. Calculated
   in quarters, whose sums do not overflow. */
static int32 is_inside(const struct shade_plan *plan, const struct texturing *t,
                       const struct vertex *v, int32 count)
{
    if (plan->dcdx >= STEEP_1 || plan->dcdx <= -STEEP_1 || plan->dcdy >= STEEP_1
        || plan->dcdy <= -STEEP_1)
        return 0;
    for (; count > 0; count--, v++) {
        fix16 quarter = ((fix16)t->u >> 2)
                      + (mul_fix(plan->dcdx, v->x - (t->i << 16)) >> 2)
                      + (mul_fix(plan->dcdy, v->y - (t->j << 16)) >> 2);

        if (quarter < (plan->low + INSET) >> 2 || quarter > (plan->high - INSET) >> 2)
            return 0;
    }
    return 1;
}

void shading_lines(struct setup *s, uint32 *shades)
{
    struct span_plan *span = &s->span;
    const struct sides *sides = &s->sides;
    const struct vertex *vertices = s->vertices;
    const struct rectangle *box = &s->box;
    struct vertex corners[3];
    struct sides shaded;        /* as far as texturing_plane reads it */
    struct texturing t;
    struct shade_plan plan;

    shaded.top = lit(&corners[0], sides->top);
    shaded.bottom = lit(&corners[1], sides->bottom);
    shaded.middle = lit(&corners[2], sides->middle);
    shaded.area = sides->area;
    shaded.middle_right = sides->middle_right;
    t.u_cut = CUT_LEVEL;
    t.v_cut = 0;
    texturing_plane(&t, &shaded, box, CHAIN_NONE);
    plan.lines = span->lines;
    plan.count = span->count;
    plan.shades = shades;
    plan.dcdx = t.dudx;
    plan.dcdy = t.dudy;
    plan.shade = t.u
               + (uint32)plan.dcdy * (uint32)(box->top - t.j)
               - (uint32)plan.dcdx * (uint32)(EDGE_BIAS + t.i);
    plan.low = plan.high = SHADE_LEVEL(vertices->shade);
    for (int32 k = 1; k < s->count; k++) {
        fix16 level = SHADE_LEVEL(vertices[k].shade);

        plan.low = level < plan.low ? level : plan.low;
        plan.high = level > plan.high ? level : plan.high;
    }
    plan.low &= ~0xffff;
    plan.high = (plan.high | 0xffff) - FREE_BITS;
    plan.inside = is_inside(&plan, &t, vertices, s->count);
    plan.added = (uint32)span->light & 0xffff;
    if (s->kind == SPAN_PERSPECTIVE)
        plan.added += plan.dcdx < 0 ? LEVEL_FALLS : 0;
    else if (span->dvdx & 0x800000)
        plan.added += SHADE_FALLS;
    edge_shade(&plan);
    span->shades = shades;
    span->dcdx = plan.dcdx;
}
