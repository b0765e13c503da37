#include "drawing/lower.h"
#include "drawing/material.h"
#include "math/math.h"
#include "polygon/counts.h"
#include "polygon/shading.h"

/* INSET: how far u and v of a triangle may be outside the vertices' range at a pixel's centre. The
   parts, in 1/2^17 texel, 8,192 in all: edges by EDGES_32: 4,096. 512 steps are rounded by 1 each in both
   directions, 1,024, and starts are raised by as much; the plane itself is off by less than 512, as
   gradients below STEEP_256 are off by 1/2^23 texel a pixel over 2^15 pixels, and starts are raised by
   twice that. Gentle planes have shorter ways: their parts are smaller. ON_PLANE: only the edges count if
   the range is that of the stepped plane. EDGES_32: rounded edges are off by 1/2^17 pixel a line and 1/2^17
   more; the step times that stays below it. Cutting vertices moves them more, so with it steps are below
   STEEP_4. */
#define INSET SHADE_INSET
#define ON_PLANE (3 * INSET / 4)

/* Returns non-zero if the error of edges or of gradients may move u or v by more than INSET
   allows. */
static int32 is_steep(const struct setup *s)
{
    const uint32 u = fix_magnitude(s->span.dudx);
    const uint32 v = s->material->mapper == MAPPER_GOURAUD ? 0 : fix_magnitude(s->span.dvdx);

    return (u > v ? u : v) >= material_steep(s->material, s->span.count);
}

/* Finds the least and the greatest value of a coordinate's stepped plane at the vertices. Each
   value is the sum of three vertices' values times -1 to 2: no overflow. */
static void plane_range(uint32 at, fix16 ddx, fix16 ddy, const struct texturing *t,
                        const struct vertex *v, int32 count, fix16 *low, fix16 *high)
{
    *low = 0x7fffffff;
    *high = -0x7fffffff;
    for (; count > 0; count--, v++) {
        fix16 value = (fix16)(at + (uint32)mul_fix(ddx, v->x - (t->i << 16))
                              + (uint32)mul_fix(ddy, v->y - (t->j << 16)));

        if (value < *low)
            *low = value;
        if (value > *high)
            *high = value;
    }
}

/* Sets the ranges that u and v of every pixel must stay in: MAPPER_GOURAUD, MAPPER_ARBITRARY. */
static void find_range(struct clamp_plan *clamp, const struct setup *s)
{
    clamp->u_low = clamp->v_low = clamp->v_high = 0;
    if (s->material->mapper == MAPPER_GOURAUD) {
        clamp->u_high = vertex_range(&s->vertices->s, s->count, &clamp->u_low);
        clamp->u_high += clamp->u_low;
        clamp->u_low &= ~0xffff;
        clamp->u_high |= 0xffff;
    } else {
        clamp->u_high = (s->material->map->width << 16) - 1;
        clamp->v_high = (s->material->map->height << 16) - 1;
    }
}

/* Returns non-zero if a pixel might leave these ranges, by errors of edges and of the stepped plane. */
static int32 leaves_range(const struct setup *s)
{
    const struct texturing *t = &s->texturing;
    int32 gouraud = s->material->mapper == MAPPER_GOURAUD;
    fix16 s_low, s_high, t_low = 0, t_high = 0, inset = INSET;
    struct clamp_plan clamp;

    if (is_steep(s))
        return 1;
    if (gouraud && s->count == 3)
        return 0;               /* material_made has limited the shades */
    if (s->count == 3) {
        s_high = vertex_range(&s->vertices->s, 3, &s_low);
        s_high += s_low;
        t_high = vertex_range(&s->vertices->t, 3, &t_low);
        t_high += t_low;
    } else {                    /* the plane need not go through all vertices */
        inset = ON_PLANE;
        plane_range(t->u, t->dudx, t->dudy, t, s->vertices, s->count, &s_low, &s_high);
        if (!gouraud)
            plane_range(t->v, t->dvdx, t->dvdy, t, s->vertices, s->count, &t_low, &t_high);
    }
    find_range(&clamp, s);
    return s_low < clamp.u_low + inset || s_high > clamp.u_high - inset
        || (!gouraud && (t_low < inset || t_high > clamp.v_high - inset));
}

/* Returns a step, made two units slower if it falls: the start of a line may be moved one unit
   below the far border, and u is above the exact value again a pixel on. */
static fix16 slower(fix16 step)
{
    return step >= 0 ? step : step < -2 ? step + 2 : 0;
}

/* Returns non-zero if lines need not be moved to keep u and v in range. */
static int32 lower_to_no_clamp(struct setup *s, int32 leaves_range)
{
    if (!RULE_IS_ON(s, INSIDE_RANGE) || leaves_range)
        return 0;
    RULE_APPLIES(s, INSIDE_RANGE);
    return 1;
}

void clamp_lines(struct setup *s)
{
    struct clamp_plan clamp;
    int32 leaves = leaves_range(s);

    if (lower_to_no_clamp(s, leaves))
        return;
    find_range(&clamp, s);
    clamp.lines = (struct scanline *)s->span.lines;
    clamp.count = s->span.count;
    clamp.dudx = leaves ? slower(s->span.dudx) : s->span.dudx;
    clamp.dvdx = leaves ? slower(s->span.dvdx) : s->span.dvdx;
    edge_clamp(&clamp);
    s->span.dudx = clamp.dudx;
    s->span.dvdx = clamp.dvdx;
}
