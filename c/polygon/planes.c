#include "polygon/planes.h"

#include "math/math.h"

void planes_open(struct planes_corners *corners, const struct setup *s)
{
    struct sides *sides = &corners->sides;

    sides->top = &corners->of[0];
    sides->bottom = &corners->of[1];
    sides->middle = &corners->of[2];
    sides->area.hi = s->sides.area.hi;
    sides->area.lo = s->sides.area.lo;
    sides->middle_right = s->sides.middle_right;
    for (int32 n = 0; n < PLANES_CORNERS; n++) {
        const struct vertex *corner = planes_corner(s, s->given, n);

        corners->of[n].x = corner->x;
        corners->of[n].y = corner->y;
    }
}

static void find_pair(struct planes *planes, const struct setup *s, const struct sides *sides,
                      int32 first, int32 bits, enum chain chain, struct texturing *t)
{
    struct plane *a = &planes->of[first], *b = a + 1;

    t->u_cut = t->v_cut = 0;
    texturing_plane(t, sides, &s->box, chain);
    planes->i = t->i;
    planes->j = t->j;
    a->at = t->u << bits;
    a->dx = (uint32)t->dudx << bits;
    a->dy = (uint32)t->dudy << bits;
    b->at = t->v << bits;
    b->dx = (uint32)t->dvdx << bits;
    b->dy = (uint32)t->dvdy << bits;
}

void planes_pair(struct planes *planes, const struct setup *s, const struct planes_corners *corners,
                 int32 first)
{
    struct texturing t;

    find_pair(planes, s, &corners->sides, first, 0, CHAIN_NONE, &t);
}

/* Returns the whole pixels between a corner's coordinate and a pixel's, rounded down. */
static int32 way(fix16 from, int32 to)
{
    return (int32)(fix_magnitude((fix16)((uint32)to << 16) - from) >> 16);
}

/* Returns the units by which u of a plane may be above the exact one at any pixel of the box: twice
   its possible shortfall (texturing_plane). Steps are off by half a unit; a gradient is less than
   one texel above the whole texels of its step. */
static int32 above(const struct setup *s, const struct texturing *t)
{
    const struct vertex *top = s->sides.top;
    const int32 sides = t->i - s->box.left + t->j - s->box.top;
    const int32 ways = way(top->x, t->i) + way(top->y, t->j) + sides + 2;
    const int32 steep = (int32)((fix_magnitude(t->dudx) >> 16) + (fix_magnitude(t->dudy) >> 16)) + 7;

    return sides + 2 * mul_shift(steep, 2 * ways, 16) + 6;
}

/* Properties of the corners' w. */
struct depths {
    fix16 least;                /* |w| */
    int32 is_constant, is_positive;
};

static void find_depths(struct depths *depths, const struct vertex *corners, int32 count)
{
    const fix16 first = corners->w;
    uint32 least = fix_magnitude(first);

    depths->is_constant = depths->is_positive = 1;
    for (; count; count--, corners++) {
        if (fix_magnitude(corners->w) < least)
            least = fix_magnitude(corners->w);
        if (corners->w != first)
            depths->is_constant = 0;
        if (corners->w < 0)
            depths->is_positive = 0;
    }
    depths->least = (fix16)least;
}

/* Returns non-zero if no coordinate is more than half the reach from 0, which is a power of two: then
   all are less than that apart. */
static int32 is_small(const struct vertex *v, int32 count, fix16 reach)
{
    fix16 any = 0;

    for (; count > 0; count--, v++)
        any |= (v->s ^ v->s >> 31) | (v->t ^ v->t >> 31);
    return any < reach >> 1;
}

static int32 is_narrow(const fix16 *value, int32 count, fix16 reach)
{
    fix16 least;

    return vertex_range(value, count, &least) < reach;
}

/* Raises the plane of S or T of divided corners. value: the first one's s or t. The raise is the
   largest value times the units by which W may be too high, with 3 more for W's rounding at the
   corners, and 3 units for S's rounding. */
static void raise_divided(struct plane *plane, const fix16 *value, int32 count,
                          const struct planes_scale *scale, int32 too_high)
{
    fix16 least;
    const uint32 range = (uint32)vertex_range(value, count, &least);
    const uint32 low = fix_magnitude(least), high = fix_magnitude((fix16)((uint32)least + range));
    const uint32 largest = (low > high ? low : high) << scale->bits;

    plane->at += (uint32)mul_div(largest > 0x7fffffff ? 0x7fffffff : (int32)largest, too_high + 3,
                                 scale->one) + 3;
}

static void find_divided(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *vertices, const struct planes_scale *scale,
                         const struct depths *depths)
{
    struct planes_division division;
    struct planes_corners corners;
    struct texturing t;
    int32 too_high;

    planes_open(&corners, s);
    for (int32 n = 0; n < PLANES_CORNERS; n++) {
        const struct vertex *v = planes_corner(s, vertices, n);

        corners.of[n].s = v->s;
        corners.of[n].t = v->t;
        corners.of[n].w = v->w;
    }
    division.least = (uint32)depths->least;
    division.nearest = depths->is_positive ? scale->one : scale->one >> 1;
    division.one = scale->one;
    division.bits = scale->bits;
    corners_divide(corners.of, &division);
    planes_pair(planes, s, &corners, first);
    for (int32 n = 0; n < PLANES_CORNERS; n++)
        corners.of[n].s = corners.of[n].w;
    find_pair(planes, s, &corners.sides, first + 2, 0, CHAIN_SHADES, &t);
    too_high = above(s, &t);
    raise_divided(&planes->of[first], &vertices->s, s->count, scale, too_high);
    raise_divided(&planes->of[first + 1], &vertices->t, s->count, scale, too_high);
}

static void find_plain(struct planes *planes, const struct setup *s, int32 first,
                       const struct vertex *vertices, const struct planes_scale *scale)
{
    struct plane *w = &planes->of[first + 2];
    const struct sides *sides = &s->sides;
    struct planes_corners corners;
    struct texturing t;

    if (vertices != s->given) {
        planes_open(&corners, s);
        for (int32 n = 0; n < PLANES_CORNERS; n++) {
            const struct vertex *v = planes_corner(s, vertices, n);

            corners.of[n].s = v->s;
            corners.of[n].t = v->t;
        }
        sides = &corners.sides;
    }
    find_pair(planes, s, sides, first, scale->bits, CHAIN_NONE, &t);
    w->at = (uint32)scale->one;
    w->dx = w->dy = 0;
}

int32 planes_coordinates(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *vertices, const struct planes_scale *scale,
                         int32 perspective)
{
    struct depths depths;

    if (!is_small(vertices, s->count, scale->reach)
        && !(is_narrow(&vertices->s, s->count, scale->reach)
             && is_narrow(&vertices->t, s->count, scale->reach)))
        return 0;
    if (perspective)
        find_depths(&depths, vertices, s->count);
    if (perspective && !(depths.is_constant && depths.is_positive))
        find_divided(planes, s, first, vertices, scale, &depths);
    else
        find_plain(planes, s, first, vertices, scale);
    return 1;
}

uint32 planes_at(const struct planes *planes, int32 which, int32 x, int32 y)
{
    const struct plane *plane = &planes->of[which];

    return plane->at + (uint32)(x - planes->i) * plane->dx + (uint32)(y - planes->j) * plane->dy;
}
