#include "n64/polygons/planes.h"

static const struct planes_scale scale = {5, N64_W_ONE, 1024 << 16};

static void find_shades(struct n64_planes *planes, const struct setup *s, const uint32 *colours)
{
    struct vertex *corners = planes_vertices(s->scratch, s->given, s->count);

    for (int32 pair = 0; pair < 2; pair++) {
        for (int32 i = 0; i < s->count; i++) {
            uint32 channels = colours ? colours[i] >> (16 - 16 * pair) : 0;
            fix16 shade = s->given[i].shade;

            corners[i].s = colours ? (fix16)(channels << 8 & 0xff0000) : shade;
            corners[i].t = colours ? (fix16)(channels << 16 & 0xff0000)
                         : pair ? 255 << 16 : shade;
        }
        planes_pair(&planes->all, s, N64_RED + 2 * pair, 0);
    }
}

int32 n64_planes_find(struct n64_planes *planes, const struct setup *s, int32 perspective,
                      int32 shades, const uint32 *colours)
{
    planes->divided = perspective;
    planes->shaded = shades;
    if (!planes_coordinates(&planes->all, s, N64_S, s->given, &scale, perspective))
        return 0;
    if (shades)
        find_shades(planes, s, colours);
    return 1;
}

uint32 n64_plane_at(const struct n64_planes *planes, enum n64_interpolant which, int32 x, int32 y)
{
    return planes_at(&planes->all, which, x, y);
}

static void set_iterators(struct n64_iterators *to, uint32 s, uint32 t, uint32 w)
{
    to->s = (int32)s;
    to->t = (int32)t;
    to->w = (int32)w;
}

void n64_planes_point(const struct n64_planes *planes, int32 x, int32 y, struct n64_point *point)
{
    const struct plane *of = planes->all.of;

    set_iterators(&point->at, n64_plane_at(planes, N64_S, x, y), n64_plane_at(planes, N64_T, x, y),
                  n64_plane_at(planes, N64_W, x, y));
    set_iterators(&point->dx, of[N64_S].dx, of[N64_T].dx, of[N64_W].dx);
    set_iterators(&point->dy, of[N64_S].dy, of[N64_T].dy, of[N64_W].dy);
}
