#include "polygon/planes.h"

#include "math/math.h"

struct vertex *planes_vertices(struct scratch *scratch, const struct vertex *vertices,
                               int32 count)
{
    struct vertex *corners = scratch->corners;

    for (int32 i = 0; i < count; i++) {
        corners[i].x = vertices[i].x;
        corners[i].y = vertices[i].y;
        corners[i].s = corners[i].t = 0;
    }
    return corners;
}

static void find_pair(struct planes *planes, const struct setup *s, int32 first, int32 bits,
                      struct texturing *t)
{
    struct plane *a = &planes->of[first], *b = a + 1;

    t->u_cut = t->v_cut = 0;
    texturing_plane(t, &s->sides, &s->box, CHAIN_NONE);
    planes->i = t->i;
    planes->j = t->j;
    a->at = t->u << bits;
    a->dx = (uint32)t->dudx << bits;
    a->dy = (uint32)t->dudy << bits;
    b->at = t->v << bits;
    b->dx = (uint32)t->dvdx << bits;
    b->dy = (uint32)t->dvdy << bits;
}

void planes_pair(struct planes *planes, const struct setup *s, int32 first, int32 bits)
{
    struct texturing t;

    find_pair(planes, s, first, bits, &t);
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

/* Raises the plane of S or T of divided corners. value: the first corner's s or t. The raise is the
   largest value times the units by which W may be too high, with 3 more for W's rounding at the
   corners, and 3 units for S's rounding. */
static void raise_divided(struct plane *plane, const fix16 *value, int32 count,
                          const struct planes_scale *scale, int32 too_high)
{
    fix16 least;
    const uint32 range = vertex_range(value, count, &least);
    const uint32 low = fix_magnitude(least), high = fix_magnitude((fix16)((uint32)least + range));
    const uint32 largest = (low > high ? low : high) << scale->bits;

    plane->at += (uint32)mul_div(largest > 0x7fffffff ? 0x7fffffff : (int32)largest, too_high + 3,
                                 scale->one) + 3;
}

static void find_divided(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *corners, const struct planes_scale *scale,
                         const struct depths *depths)
{
    const int32 one = depths->is_positive ? scale->one : scale->one >> 1;
    struct vertex *places = s->scratch->corners;
    const struct vertex *v = corners;
    fix16 w[POLYGON_VERTICES_MAX];
    struct texturing t;
    int32 too_high;

    for (int32 i = 0; i < s->count; i++, v++) {
        w[i] = mul_div(one, depths->least, (fix16)fix_magnitude(v->w));
        if (v->w < 0)
            w[i] = -w[i];
        places[i].s = mul_div((fix16)((uint32)v->s << scale->bits), w[i], scale->one);
        places[i].t = mul_div((fix16)((uint32)v->t << scale->bits), w[i], scale->one);
    }
    planes_pair(planes, s, first, 0);
    for (int32 i = 0; i < s->count; i++) {
        places[i].s = w[i];
        places[i].t = 0;
    }
    find_pair(planes, s, first + 2, 0, &t);
    too_high = above(s, &t);
    raise_divided(&planes->of[first], &corners->s, s->count, scale, too_high);
    raise_divided(&planes->of[first + 1], &corners->t, s->count, scale, too_high);
}

static void find_plain(struct planes *planes, const struct setup *s, int32 first,
                       const struct vertex *corners, const struct planes_scale *scale)
{
    struct vertex *places = s->scratch->corners;
    struct plane *w = &planes->of[first + 2];

    for (int32 i = 0; i < s->count; i++, corners++) {
        places[i].s = corners->s;
        places[i].t = corners->t;
    }
    planes_pair(planes, s, first, scale->bits);
    w->at = (uint32)scale->one;
    w->dx = w->dy = 0;
}

static int32 is_narrow(const fix16 *value, int32 count, fix16 reach)
{
    fix16 least;

    return vertex_range(value, count, &least) < reach;
}

int32 planes_coordinates(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *corners, const struct planes_scale *scale,
                         int32 perspective)
{
    struct depths depths;

    if (!is_narrow(&corners->s, s->count, scale->reach)
        || !is_narrow(&corners->t, s->count, scale->reach))
        return 0;
    if (perspective)
        find_depths(&depths, corners, s->count);
    if (perspective && !(depths.is_constant && depths.is_positive))
        find_divided(planes, s, first, corners, scale, &depths);
    else
        find_plain(planes, s, first, corners, scale);
    return 1;
}

uint32 planes_at(const struct planes *planes, int32 which, int32 x, int32 y)
{
    const struct plane *plane = &planes->of[which];

    return plane->at + (uint32)(x - planes->i) * plane->dx + (uint32)(y - planes->j) * plane->dy;
}
