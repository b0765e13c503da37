/* Decides which polygons of more than three vertices are drawn in one piece.

   The plane goes through three corners (sides.h); the other corners may be off it by rounding
   errors. All values, x and y too, are in units of 1/65536; g and h are the plane's gradients.
   Values that were on one plane before they and their x and y were rounded are off it by

       e = S + X (|g| + |h|)

   S = 1: half a unit from writing the value and half from cutting an edge there. X = 7/4: x and y
   may also have been rotated, which turns the half unit into 0.71 and adds 1 for two rounded
   products. The errors of the three corners are weighted by the vertex's barycentric coordinates.
   These add up to 3 at most in size, because no vertex is above the top, below the bottom or
   farther from the line between the two than the middle vertex. With the vertex's own error that
   is 4 e.

   The steps of texturing_plane, taken here from the top corner, are off by 2 units (two products
   rounded down), half a unit for each pixel of the way (steps), and 2 (|g| + |h|) + 3 (gradients
   before they are rounded to steps, over 65,536 pixels). The sum is

       9 + way / 2 + 9 (|g| + |h|)

   or, with the seven parts rounded up, 15 + way / 2 + 9 (|g| + |h|). The code has the gradients of
   the rounded corners: if the polygon is thicker than 1/512 pixel, e is less than 8/7 of the value
   calculated from these. So 4 e becomes 1 + 4 + 8 (|g| + |h|), and the limit is

       16 + way / 2 + 10 (|g| + |h|).

   Integer edges and maps of other sizes than 256 texels make no difference: the test uses the
   vertices as given. */
#include "drawing/fan.h"

#include "drawing/draw.h"
#include "math/math.h"
#include "polygon/planes.h"
#include "polygon/texturing.h"
#include "triangle/polygon.h"

#define ROUNDED 16
#define QUICK_PLACE 7               /* 4 X, and 4 S */
#define QUICK_VALUE 4
#define COLOUR_ROUNDED (2 << 16)    /* colours are whole numbers: 4 times half of one */

/* 1/w of the nearest vertex; S q and T q are below it. */
#define Q_ONE (1 << 29)

/* A polygon whose values are tested a pair at a time, as s and t of its corners. */
struct look {
    struct sides sides;
    struct rectangle box;           /* pixels */
    const struct vertex *corners;
    int32 count;
};

/* Returns 1 if a value is off the plane by `most` and half a unit a pixel of the way at most. It
   is x and y away from the top corner and `rise` above that one's value. */
static int32 is_near(fix16 x, fix16 y, uint32 rise, fix16 ddx, fix16 ddy, uint32 most)
{
    const uint32 off = (uint32)mul_fix(ddx, x) + (uint32)mul_fix(ddy, y) - rise;

    return fix_magnitude((fix16)off)
        <= most + (((fix_magnitude(x) >> 16) + (fix_magnitude(y) >> 16)) >> 1);
}

/* Returns the units of 10 times a gradient. */
static uint32 moved(fix16 gradient)
{
    const uint32 size = fix_magnitude(gradient);

    return (size >> 13) + (size >> 15);
}

static uint32 limit(fix16 ddx, fix16 ddy, uint32 more)
{
    return ROUNDED + more + moved(ddx) + moved(ddy);
}

/* Returns 1 if s and t of all corners are on planes. more_s, more_t: units that s and t may be off
   in addition to the limit above. */
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
        if (v != top && v != look->sides.bottom && v != look->sides.middle
            && (!is_near(v->x - top->x, v->y - top->y, (uint32)v->s - (uint32)top->s, t.dudx,
                         t.dudy, most_s)
                || !is_near(v->x - top->x, v->y - top->y, (uint32)v->t - (uint32)top->t, t.dvdx,
                            t.dvdy, most_t)))
            return 0;
    return 1;
}

/* Returns the middle of the values' range. Raises *scale until no value is 2^scale or more away
   from it. */
static fix16 middle(const fix16 *value, int32 count, int32 *scale)
{
    fix16 least, range = vertex_range(value, count, &least);

    while ((range - (range >> 1)) >> *scale)
        ++*scale;
    return least + (range >> 1);
}

/* q is Q_ONE |w|least / w, rounded to the nearest (1/2). An error of one unit in w changes q by
   Q_ONE / |w|least at most. s q / 2^scale has that error, that of one unit of s times q, and one
   more unit because it is rounded down. */
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

/* more: units that shades may be off in addition to rounding. */
static int32 shades_lie(const struct look *look, struct vertex *to, const struct vertex *v, uint32 more)
{
    for (int32 i = 0; i < look->count; i++) {
        to[i].s = v[i].shade;
        to[i].t = 0;
    }
    return lie_on_planes(look, more, 0);
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

/* Returns 1 if x, y, s and t of four vertices form a parallelogram within rounding. Those of most
   quads do, and then s and t are off their plane by 4 e at most. */
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

/* Returns 1 if s and t are constant or those of a parallelogram, and w is constant if `asked` has
   PLANAR_DEPTHS. Returns 0 if other values are asked for. */
static int32 is_quick(const struct vertex *p, const struct vertex *v, int32 count, uint32 asked)
{
    return !(asked & ~(uint32)(PLANAR_TEXELS | PLANAR_DEPTHS))
        && ((count == 4 && is_parallelogram(p, v))
            || (v[0].s == v[1].s && v[0].t == v[1].t
                && is_constant(&v->s, count) && is_constant(&v->t, count)))
        && (!(asked & PLANAR_DEPTHS) || is_constant(&v->w, count));
}

/* Returns 0 if the polygon cannot be tested. s and t of the corners are in the range of x and y. */
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
    struct vertex *const corners = scratch->corners;
    struct look look;
    uint32 found = asked & PLANAR_ROUGH;

    if (is_quick(places, values, count, asked))
        return asked;
    if (asked == PLANAR_TEXELS && places == values)
        return !begin(&look, places, count) || lie_on_planes(&look, 0, 0) ? asked : 0;
    for (int32 i = 0; i < count; i++) {
        corners[i].x = places[i].x;
        corners[i].y = places[i].y;
        corners[i].s = values[i].s;
        corners[i].t = values[i].t;
    }
    if (!begin(&look, corners, count))
        return asked;
    if (asked & PLANAR_TEXELS && lie_on_planes(&look, 0, 0))
        found |= PLANAR_TEXELS;
    if (asked & PLANAR_DEPTHS && depths_lie(&look, corners, values))
        found |= PLANAR_DEPTHS;
    if (asked & PLANAR_SHADES && shades_lie(&look, corners, values, asked & PLANAR_ROUGH ? PLANAR_SHADE : 0))
        found |= PLANAR_SHADES;
    if (asked & PLANAR_COLOURS && colours_lie(&look, corners, values))
        found |= PLANAR_COLOURS;
    return found;
}

int32 polygon_may_be_fan(const struct renderer *renderer, const struct polygon *polygon,
                           const struct material *material)
{
    return polygon->count > 3
        && ((material->edges == EDGES_SNAPPED && renderer->triangles) || material->gradients == GRADIENTS_POLYGON
            || (planes_asked(material) & ~polygon->planar) != 0);
}

int32 polygon_is_fan(const struct renderer *renderer, const struct polygon *polygon, const struct material *material)
{
    if (!polygon_may_be_fan(renderer, polygon, material))
        return 0;
    if (material->edges == EDGES_SNAPPED && renderer->triangles && triangle_takes(renderer->frame, polygon, material))
        return 1;
    if (material->mapper == MAPPER_FLAT)
        return 0;
    return material->gradients == GRADIENTS_POLYGON
        || !polygon_is_planar(renderer, polygon, polygon->vertices, planes_asked(material));
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
