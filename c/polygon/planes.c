#include "polygon/planes.h"

#include "polygon/math.h"

static struct vertex places[POLYGON_VERTICES_MAX];

struct vertex *planes_vertices(const struct vertex *vertices, int32 count)
{
    for (int32 i = 0; i < count; i++) {
        places[i].x = vertices[i].x;
        places[i].y = vertices[i].y;
        places[i].s = places[i].t = 0;
    }
    return places;
}

void planes_pair(struct planes *planes, const struct setup *s, int32 first, int32 bits)
{
    struct plane *a = &planes->of[first], *b = a + 1;
    struct texturing t;

    t.u_cut = t.v_cut = 0;
    texturing_plane(&t, &s->sides, &s->box, CHAIN_NONE);
    planes->i = t.i;
    planes->j = t.j;
    a->at = t.u << bits;
    a->dx = (uint32)t.dudx << bits;
    a->dy = (uint32)t.dudy << bits;
    b->at = t.v << bits;
    b->dx = (uint32)t.dvdx << bits;
    b->dy = (uint32)t.dvdy << bits;
}

/* What w of the corners are like. */
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

static void find_divided(struct planes *planes, const struct setup *s, int32 first,
                         const struct vertex *corners, const struct planes_scale *scale,
                         const struct depths *depths)
{
    const int32 one = depths->is_positive ? scale->one : scale->one >> 1;
    fix16 w[POLYGON_VERTICES_MAX];

    for (int32 i = 0; i < s->count; i++, corners++) {
        w[i] = mul_div(one, depths->least, (fix16)fix_magnitude(corners->w));
        if (corners->w < 0)
            w[i] = -w[i];
        places[i].s = mul_div((fix16)((uint32)corners->s << scale->bits), w[i], scale->one);
        places[i].t = mul_div((fix16)((uint32)corners->t << scale->bits), w[i], scale->one);
    }
    planes_pair(planes, s, first, 0);
    for (int32 i = 0; i < s->count; i++) {
        places[i].s = w[i];
        places[i].t = 0;
    }
    planes_pair(planes, s, first + 2, 0);
}

static void find_plain(struct planes *planes, const struct setup *s, int32 first,
                       const struct vertex *corners, const struct planes_scale *scale)
{
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
