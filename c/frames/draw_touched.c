#include "frames/draw_touched.h"

#include "triangle/polygon.h"

enum { MOST = 0x7fffffff };

/* Around vertices, 16.16. */
struct extent {
    fix16 left, top, right, bottom;
};

static void begin(struct extent *extent)
{
    extent->left = extent->top = MOST;
    extent->right = extent->bottom = -MOST;
}

static void add(struct touched *touched, const struct extent *extent)
{
    struct rectangle box;

    if (extent->left > extent->right)
        return;
    box.left = extent->left >> 16;
    box.top = extent->top >> 16;
    box.right = (extent->right >> 16) + 1;
    box.bottom = (extent->bottom >> 16) + 1;
    touched_add(touched, &box);
}

void touched_vertices(struct touched *touched, const struct vertex *v, int32 count)
{
    fix16 left = MOST, top = MOST, right = -MOST, bottom = -MOST;
    struct extent extent;

    for (; count > 0; count--, v++) {
        const fix16 x = v->x, y = v->y;

        left = x < left ? x : left;
        right = x > right ? x : right;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    extent.left = left;
    extent.top = top;
    extent.right = right;
    extent.bottom = bottom;
    add(touched, &extent);
}

/* Makes an extent wider by the places that are marked and in range; returns how many marked ones are not. */
static int32 include_places(struct extent *extent, const struct mesh_place *place, const uint8 *mark, uint32 points)
{
    int32 left = MOST, right = 0, off = 0;      /* x and y: x is the upper word */
    int32 top = MOST, bottom = 0;               /* y */

    for (; points; points--, mark++, place++) {
        const int32 both = place->place, y = (int16)both;

        if (!*mark)
            continue;
        if (both < 0) {
            off++;
            continue;
        }
        left = both < left ? both : left;
        right = both > right ? both : right;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    if (left == MOST)
        return off;
    extent->left = ((left >> 16) - SNAPPED_ONE) << (16 - SNAPPED_BITS);
    extent->right = ((right >> 16) - SNAPPED_ONE) << (16 - SNAPPED_BITS);
    extent->top = (top - SNAPPED_ONE) << (16 - SNAPPED_BITS);
    extent->bottom = (bottom - SNAPPED_ONE) << (16 - SNAPPED_BITS);
    return off;
}

/* The same by points inside all borders; with places, by those that are off there. */
static void include_points(struct extent *extent, const struct mesh_placed *placed, const struct mesh_place *place,
                           const uint8 *mark)
{
    const struct mesh_point *p = placed->points;
    fix16 left = extent->left, top = extent->top, right = extent->right, bottom = extent->bottom;

    for (uint32 points = placed->mesh->points; points; points--, mark++, p++) {
        const int32 is_placed = place && place++->place >= 0;
        const fix16 x = p->screen_x, y = p->screen_y;

        if (!*mark || is_placed || p->outside)
            continue;
        left = x < left ? x : left;
        right = x > right ? x : right;
        top = y < top ? y : top;
        bottom = y > bottom ? y : bottom;
    }
    extent->left = left;
    extent->top = top;
    extent->right = right;
    extent->bottom = bottom;
}

void touched_instance(struct touched *touched, const struct mesh_placed *placed, const uint8 *marks)
{
    const struct mesh_place *const places = placed->view16 ? placed->places : 0;
    struct extent extent;

    begin(&extent);
    if (!places || include_places(&extent, places, marks, placed->mesh->points))
        include_points(&extent, placed, places, marks);
    add(touched, &extent);
}
