#include "polygon/shading.h"

#include "polygon/texturing.h"

/* A level is a quarter of a shade. Spans keep the two lowest bits of its fraction for
   wraps of v: all levels are multiples of 4 units. */
#define LEVEL_OF(shade) ((shade) >> 2)
#define FREE_BITS 3

int32 shading_light(struct span_plan *span, const struct material *material,
                    const struct vertex *vertices)
{
    if (!material->light || material->light->layout != MAP_LIGHT)
        return 0;
    span->light = material->light->texels;
    if (material->mapper == MAPPER_LIT)
        span->light += 256 * (LEVEL_OF(vertices->shade) >> 16);
    return 1;
}

/* A corner with its level in the place of s. */
static const struct vertex *lit(struct vertex *to, const struct vertex *from)
{
    to->x = from->x;
    to->y = from->y;
    to->s = LEVEL_OF(from->shade);
    to->t = 0;
    return to;
}

static fix16 rounded(fix16 step)
{
    return (fix16)(((uint32)step + 2) & ~(uint32)FREE_BITS);
}

void shading_lines(struct span_plan *span, const struct sides *sides,
                   const struct vertex *vertices, int32 count, const struct rectangle *box)
{
    static uint32 shades[SCENE_SIDE_MAX];
    struct vertex corners[3];
    struct sides shaded;        /* as far as texturing_plane reads it */
    struct texturing t;
    struct shade_plan plan;

    shaded.top = lit(&corners[0], sides->top);
    shaded.bottom = lit(&corners[1], sides->bottom);
    shaded.apex = lit(&corners[2], sides->apex);
    shaded.area = sides->area;
    shaded.apex_right = sides->apex_right;
    texturing_plane(&t, &shaded, box, CHAIN_NONE);
    plan.lines = span->lines;
    plan.count = span->count;
    plan.shades = shades;
    plan.dcdx = rounded(t.dudx);
    plan.dcdy = rounded(t.dudy);
    plan.shade = (t.u & ~(uint32)FREE_BITS)
               + (uint32)plan.dcdy * (uint32)(box->top - t.j)
               - (uint32)plan.dcdx * (uint32)(EDGE_BIAS + t.i);
    plan.low = plan.high = LEVEL_OF(vertices->shade);
    for (; count > 0; count--, vertices++) {
        fix16 level = LEVEL_OF(vertices->shade);

        plan.low = level < plan.low ? level : plan.low;
        plan.high = level > plan.high ? level : plan.high;
    }
    plan.low &= ~0xffff;
    plan.high = (plan.high | 0xffff) - FREE_BITS;
    plan.added = (uint32)span->light & 0xffff;
    if (span->dvdx & 0x800000)
        plan.added += SHADE_FALLS;
    edge_shade(&plan);
    span->shades = shades;
    span->dcdx = plan.dcdx;
}
