#include "tx/planes.h"

#include "polygon/lower.h"
#include "polygon/math.h"

static struct vertex corners[POLYGON_VERTICES_MAX];

const struct vertex *tx_planes_vertices(const struct vertex *vertices, int32 count)
{
    for (int32 i = 0; i < count; i++) {
        corners[i].x = vertices[i].x;
        corners[i].y = vertices[i].y;
        corners[i].s = corners[i].t = 0;
    }
    return corners;
}

/* The planes of what the corners' s and t are now, times 2^bits. */
static void find_pair(struct tx_planes *planes, const struct setup *s, struct tx_plane *a,
                      struct tx_plane *b, int32 bits)
{
    struct texturing t;

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

static fix16 least_w(const struct setup *s)
{
    fix16 least = s->given->w;

    for (int32 i = 1; i < s->count; i++)
        if (s->given[i].w < least)
            least = s->given[i].w;
    return least;
}

static void find_divided(struct tx_planes *planes, const struct setup *s)
{
    fix16 least = least_w(s), w[POLYGON_VERTICES_MAX];
    struct tx_plane none;

    for (int32 i = 0; i < s->count; i++) {
        w[i] = mul_div(TX_W_ONE, least, s->given[i].w);
        corners[i].s = mul_div((fix16)((uint32)s->given[i].s << 5), w[i], TX_W_ONE);
        corners[i].t = mul_div((fix16)((uint32)s->given[i].t << 5), w[i], TX_W_ONE);
    }
    find_pair(planes, s, &planes->of[TX_S], &planes->of[TX_T], 0);
    for (int32 i = 0; i < s->count; i++) {
        corners[i].s = w[i];
        corners[i].t = 0;
    }
    find_pair(planes, s, &planes->of[TX_W], &none, 0);
}

static void find_plain(struct tx_planes *planes, const struct setup *s)
{
    for (int32 i = 0; i < s->count; i++) {
        corners[i].s = s->given[i].s;
        corners[i].t = s->given[i].t;
    }
    find_pair(planes, s, &planes->of[TX_S], &planes->of[TX_T], 5);
    planes->of[TX_W].at = TX_W_ONE;
    planes->of[TX_W].dx = planes->of[TX_W].dy = 0;
}

static void find_shades(struct tx_planes *planes, const struct setup *s, const uint32 *colours)
{
    for (int32 pair = 0; pair < 2; pair++) {
        for (int32 i = 0; i < s->count; i++) {
            uint32 channels = colours ? colours[i] >> (16 - 16 * pair) : 0;
            fix16 shade = s->given[i].shade;

            corners[i].s = colours ? (fix16)(channels << 8 & 0xff0000) : shade;
            corners[i].t = colours ? (fix16)(channels << 16 & 0xff0000)
                         : pair ? 255 << 16 : shade;
        }
        find_pair(planes, s, &planes->of[TX_RED + 2 * pair], &planes->of[TX_GREEN + 2 * pair], 0);
    }
}

/* Whether the differences of s and t stay inside 31 bits. */
static int32 is_narrow(const struct setup *s)
{
    const struct vertex *v = s->given;
    fix16 s_low = v->s, s_high = v->s, t_low = v->t, t_high = v->t;
    const fix16 most = 1024 << 16;

    for (int32 i = 1; i < s->count; i++) {
        v++;
        s_low = v->s < s_low ? v->s : s_low;
        s_high = v->s > s_high ? v->s : s_high;
        t_low = v->t < t_low ? v->t : t_low;
        t_high = v->t > t_high ? v->t : t_high;
    }
    return s_high - s_low < most && t_high - t_low < most;
}

int32 tx_planes_find(struct tx_planes *planes, const struct setup *s, int32 perspective,
                     int32 shades, const uint32 *colours)
{
    if (!is_narrow(s))
        return 0;
    planes->divided = perspective;
    planes->shaded = shades;
    if (perspective && !lower_w_is_constant(s))
        find_divided(planes, s);
    else
        find_plain(planes, s);
    if (shades)
        find_shades(planes, s, colours);
    return 1;
}

uint32 tx_plane_at(const struct tx_planes *planes, enum tx_interpolant which, int32 x, int32 y)
{
    const struct tx_plane *plane = &planes->of[which];

    return plane->at + (uint32)(x - planes->i) * plane->dx + (uint32)(y - planes->j) * plane->dy;
}

static void set_iterators(struct tx_iterators *to, uint32 s, uint32 t, uint32 w)
{
    to->s = (int32)s;
    to->t = (int32)t;
    to->w = (int32)w;
}

void tx_planes_point(const struct tx_planes *planes, int32 x, int32 y, struct tx_point *point)
{
    const struct tx_plane *s = &planes->of[TX_S], *t = &planes->of[TX_T], *w = &planes->of[TX_W];

    set_iterators(&point->at, tx_plane_at(planes, TX_S, x, y), tx_plane_at(planes, TX_T, x, y),
                  tx_plane_at(planes, TX_W, x, y));
    set_iterators(&point->dx, s->dx, t->dx, w->dx);
    set_iterators(&point->dy, s->dy, t->dy, w->dy);
}
