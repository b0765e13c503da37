/* Which polygons of more than three vertices are drawn in one piece.

   The plane runs through three corners (sides.h), and the others may be off it by what rounding
   makes. Values are in units of 1/65536, x and y too; g and h are the plane's gradients. Values and
   places that were on one plane before they were rounded are off it by

       e = S + X (|g| + |h|)

   with S = 1, half a unit when they were written and another when an edge was cut there, and X =
   7/4: x and y may have been turned besides, which makes 0.71 of the half, and 1 of two products
   that are rounded. Three corners' errors count as the shares that the vertex has of them, the
   sizes of which are 3 in all at most: no vertex is above the top, below the bottom or farther
   from the line between them than the apex is. So much for 4 e. The steps that texturing_plane
   finds, as they are taken here from the top corner, are off by 2 units (two products rounded
   down), half a unit a pixel of the way (steps), and 2 (|g| + |h|) + 3 (the gradients before they
   are steps, over 65,536 pixels). That is

       9 + way / 2 + 9 (|g| + |h|)

   and 15 + way / 2 where the seven parts are rounded up. The gradients are those of the rounded
   corners: e is less than 8/7 of what they make of it where the polygon is thicker than 1/512
   pixel. 4 e becomes 1 + 4 + 8 (|g| + |h|) by that, and all

       16 + way / 2 + 10 (|g| + |h|).

   Where edges are integer, or the map has other than 256 texels, it makes no difference: this looks
   at the vertices as they are given. */
#include "drawing/fan.h"

#include "math/math.h"
#include "polygon/planes.h"
#include "polygon/texturing.h"

#define ROUNDED 16
#define QUICK_PLACE 7               /* 4 X, and 4 S */
#define QUICK_VALUE 4
#define COLOUR_ROUNDED (2 << 16)    /* colours are whole numbers: 4 times half of one */

/* 1/w of the nearest vertex; S q and T q are below it. */
#define Q_ONE (1 << 29)

/* A polygon whose values are looked at, a pair at a time, as s and t of its corners. */
struct look {
    struct sides sides;
    struct rectangle box;           /* pixels */
    const struct vertex *corners;
    int32 count;
};

/* Whether a value that is `rise` above the top corner's, x and y away, is off the plane by so much
   at most. */
static int32 is_near(fix16 x, fix16 y, uint32 rise, fix16 ddx, fix16 ddy, uint32 most)
{
    const uint32 off = (uint32)mul_fix(ddx, x) + (uint32)mul_fix(ddy, y) - rise;

    return fix_magnitude((fix16)off)
        <= most + (((fix_magnitude(x) >> 16) + (fix_magnitude(y) >> 16)) >> 1);
}

/* 10 times a gradient. */
static uint32 moved(fix16 gradient)
{
    const uint32 size = fix_magnitude(gradient);

    return (size >> 13) + (size >> 15);
}

static uint32 limit(fix16 ddx, fix16 ddy, uint32 more)
{
    return ROUNDED + more + moved(ddx) + moved(ddy);
}

/* more_s, more_t: units that s and t may be off beyond those above. */
static int32 lie_on_planes(const struct look *look, uint32 more_s, uint32 more_t)
{
    const struct vertex *v = look->corners, *top = look->sides.top;
    struct texturing t;
    uint32 most_s, most_t;

    t.u_cut = t.v_cut = 0;
    texturing_plane(&t, &look->sides, &look->box, CHAIN_NONE);
    most_s = limit(t.dudx, t.dudy, more_s);
    most_t = limit(t.dvdx, t.dvdy, more_t);
    for (int32 i = look->count; i > 0; i--, v++)
        if (v != top && v != look->sides.bottom && v != look->sides.apex
            && (!is_near(v->x - top->x, v->y - top->y, (uint32)v->s - (uint32)top->s, t.dudx,
                         t.dudy, most_s)
                || !is_near(v->x - top->x, v->y - top->y, (uint32)v->t - (uint32)top->t, t.dvdx,
                            t.dvdy, most_t)))
            return 0;
    return 1;
}

/* A part of s or t that is not larger than 2^scale times 1/w's; makes *scale what that needs. */
static fix16 middle(const fix16 *value, int32 count, int32 *scale)
{
    fix16 least, range = vertex_range(value, count, &least);

    while ((range - (range >> 1)) >> *scale)
        ++*scale;
    return least + (range >> 1);
}

/* q is Q_ONE |w|least / w, rounded (1/2); a unit of w makes Q_ONE / |w|least of it at most. s q,
   over 2^scale, is off by that, by a unit of s times q, and by one more: rounded down. */
static int32 depths_lie(const struct look *look, struct vertex *to, const struct vertex *v)
{
    fix16 q[POLYGON_VERTICES_MAX], s, t;
    uint32 least = fix_magnitude(v->w), unsure, unsure_product;
    int32 scale = 16;

    for (int32 i = 1; i < look->count; i++)
        if (fix_magnitude(v[i].w) < least)
            least = fix_magnitude(v[i].w);
    s = middle(&v->s, look->count, &scale);
    t = middle(&v->t, look->count, &scale);
    for (int32 i = 0; i < look->count; i++) {
        q[i] = mul_div(Q_ONE, (fix16)least, (fix16)fix_magnitude(v[i].w));
        if (v[i].w < 0)
            q[i] = -q[i];
        to[i].s = q[i];
        to[i].t = mul_shift(v[i].s - s, q[i], scale);
    }
    unsure = 4 * (uint32)Q_ONE / least;
    unsure_product = unsure + (4 * (uint32)Q_ONE >> scale) + 2;
    if (!lie_on_planes(look, unsure, unsure_product))
        return 0;
    for (int32 i = 0; i < look->count; i++) {
        to[i].s = mul_shift(v[i].t - t, q[i], scale);
        to[i].t = 0;
    }
    return lie_on_planes(look, unsure_product, 0);
}

static int32 shades_lie(const struct look *look, struct vertex *to, const struct vertex *v)
{
    for (int32 i = 0; i < look->count; i++) {
        to[i].s = v[i].shade;
        to[i].t = 0;
    }
    return lie_on_planes(look, 0, 0);
}

static int32 colours_lie(const struct look *look, struct vertex *to, const struct vertex *v)
{
    for (int32 high = 16; high >= 0; high -= 16) {
        for (int32 i = 0; i < look->count; i++) {
            const uint32 channels = (uint32)v[i].shade >> high;

            to[i].s = (fix16)(channels << 8 & 0xff0000);
            to[i].t = (fix16)(channels << 16 & 0xff0000);
        }
        if (!lie_on_planes(look, COLOUR_ROUNDED, COLOUR_ROUNDED))
            return 0;
    }
    return 1;
}

static inline int32 is_even(fix16 a, fix16 b, fix16 c, fix16 d, uint32 most)
{
    return (uint32)a - (uint32)b + (uint32)c - (uint32)d + most <= 2 * most;
}

/* Whether x, y, s and t of four vertices are a parallelogram's but for their rounding: most quads'
   are, and then s and t are off their plane by 4 e at most. */
static inline int32 is_parallelogram(const struct vertex *p, const struct vertex *v)
{
    return is_even(v[0].s, v[1].s, v[2].s, v[3].s, QUICK_VALUE)
        && is_even(v[0].t, v[1].t, v[2].t, v[3].t, QUICK_VALUE)
        && is_even(p[0].x, p[1].x, p[2].x, p[3].x, QUICK_PLACE)
        && is_even(p[0].y, p[1].y, p[2].y, p[3].y, QUICK_PLACE);
}

static int32 is_constant(const fix16 *value, int32 count)
{
    fix16 least;

    return !vertex_range(value, count, &least);
}

/* Whether s and t are the same everywhere, or a parallelogram's, and so is w where it counts. */
static int32 is_quick(const struct vertex *p, const struct vertex *v, int32 count, uint32 asked)
{
    return !(asked & ~(uint32)(PLANAR_TEXELS | PLANAR_DEPTHS))
        && ((count == 4 && is_parallelogram(p, v))
            || (v[0].s == v[1].s && v[0].t == v[1].t
                && is_constant(&v->s, count) && is_constant(&v->t, count)))
        && (!(asked & PLANAR_DEPTHS) || is_constant(&v->w, count));
}

/* 0: nothing can be said. s and t of the corners are in the range of coordinates. */
static int32 begin(struct look *look, const struct vertex *corners, int32 count)
{
    look->corners = corners;
    look->count = count;
    if (sides_find(&look->sides, corners, count) != POLYGON_DRAWN)
        return 0;
    look->box.left = look->sides.x_low >> 16;
    look->box.top = look->sides.top->y >> 16;
    look->box.right = look->sides.x_high >> 16;
    look->box.bottom = look->sides.bottom->y >> 16;
    return 1;
}

uint32 polygon_planar(struct scratch *scratch, const struct vertex *places,
                      const struct vertex *values, int32 count, uint32 asked)
{
    struct look look;
    struct vertex *corners;
    uint32 found = 0;

    if (is_quick(places, values, count, asked))
        return asked;
    if (asked == PLANAR_TEXELS && places == values)
        return !begin(&look, places, count) || lie_on_planes(&look, 0, 0) ? asked : 0;
    corners = planes_vertices(scratch, places, count);
    for (int32 i = 0; i < count; i++) {
        corners[i].s = values[i].s;
        corners[i].t = values[i].t;
    }
    if (!begin(&look, corners, count))
        return asked;
    if (asked & PLANAR_TEXELS && lie_on_planes(&look, 0, 0))
        found |= PLANAR_TEXELS;
    if (asked & PLANAR_DEPTHS && depths_lie(&look, corners, values))
        found |= PLANAR_DEPTHS;
    if (asked & PLANAR_SHADES && shades_lie(&look, corners, values))
        found |= PLANAR_SHADES;
    if (asked & PLANAR_COLOURS && colours_lie(&look, corners, values))
        found |= PLANAR_COLOURS;
    return found;
}

enum polygon_result polygon_fan(polygon_routine *draw, struct renderer *renderer,
                                const struct polygon *polygon, const struct material *material)
{
    const struct vertex *second = polygon->second;
    enum polygon_result all = POLYGON_EMPTY;
    struct vertex corners[3], coordinates[3];
    struct polygon triangle;

    polygon_set(&triangle, corners, 3, 0);
    triangle.second = second ? coordinates : 0;
    for (int32 i = 2; i < polygon->count; i++) {
        planar_triangle(corners, polygon->vertices, i);
        if (second)
            planar_triangle(coordinates, second, i);
        all = planar_both(all, draw(renderer, &triangle, material));
    }
    return all;
}
