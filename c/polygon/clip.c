#include "polygon/clip.h"

#include "math/math.h"

/* One border: a vertex is inside where its coordinate times sign is at least limit. */
struct border {
    int32 is_y;
    int32 sign;
    fix16 limit;
};

static fix16 distance(const struct vertex *v, const struct border *border)
{
    fix16 at = border->is_y ? v->y : v->x;

    return (border->sign < 0 ? -at : at) - border->limit;
}

static fix16 between(fix16 a, fix16 b, int32 part, int32 whole)
{
    return a + mul_div(b - a, part, whole);
}

/* Makes the vertex where the border cuts the edge. It is always calculated from the inner end, so
   that both directions of an edge give the same vertex. */
static void cut(struct vertex *to, const struct vertex *inside, const struct vertex *outside,
                const struct border *border)
{
    fix16 part = distance(inside, border), whole = part - distance(outside, border);
    fix16 on_border = border->sign < 0 ? -border->limit : border->limit;

    to->x = between(inside->x, outside->x, part, whole);
    to->y = between(inside->y, outside->y, part, whole);
    to->s = between(inside->s, outside->s, part, whole);
    to->t = between(inside->t, outside->t, part, whole);
    to->shade = between(inside->shade, outside->shade, part, whole);
    to->w = inside->w;          /* not interpolated: gradients of w come from the whole polygon */
    if (border->is_y)
        to->y = on_border;
    else
        to->x = on_border;
}

static int32 clip_border(struct vertex *to, const struct vertex *from, int32 count,
                         const struct border *border)
{
    const struct vertex *last = &from[count - 1];
    fix16 last_distance;
    int32 made = 0;

    if (!count)
        return 0;
    last_distance = distance(last, border);
    for (int32 i = 0; i < count; i++, from++) {
        fix16 here = distance(from, border);

        if (made > CLIP_VERTICES_MAX - 2)
            return 0;
        if (here >= 0) {
            if (last_distance < 0 && here > 0)
                cut(&to[made++], from, last, border);
            to[made++] = *from;
        } else if (last_distance > 0) {
            cut(&to[made++], last, from, border);
        }
        last = from;
        last_distance = here;
    }
    return made;
}

static int32 all_inside(const struct vertex *v, int32 count, const struct clip_window *window)
{
    for (; count > 0; count--, v++)
        if (v->x < window->left || v->x > window->right
            || v->y < window->top || v->y > window->bottom)
            return 0;
    return 1;
}

const struct vertex *polygon_clip(struct vertex *room, const struct vertex *vertices,
                                  int32 *count, const struct clip_window *window)
{
    struct vertex *other = room + CLIP_VERTICES_MAX;
    const struct border borders[4] = {
        {0, 1, window->left}, {0, -1, -window->right},
        {1, 1, window->top}, {1, -1, -window->bottom}
    };

    if (all_inside(vertices, *count, window))
        return vertices;
    for (int32 i = 0; i < 4; i++) {
        struct vertex *to = i & 1 ? other : room;

        *count = clip_border(to, vertices, *count, &borders[i]);
        vertices = to;
    }
    return vertices;
}
