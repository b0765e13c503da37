#include "frames/draw_touched.h"

#include "triangle/polygon.h"

enum { MOST = 0x7fffffff };

/* The least and the greatest x and y; right is -MOST as long as there are none. */
struct extent {
    int32 left, top, right, bottom;
};

static inline void begin(struct extent *extent)
{
    extent->left = extent->top = MOST;
    extent->right = extent->bottom = -MOST;
}

static inline void include(struct extent *extent, int32 x, int32 y)
{
    extent->left = x < extent->left ? x : extent->left;
    extent->right = x > extent->right ? x : extent->right;
    extent->top = y < extent->top ? y : extent->top;
    extent->bottom = y > extent->bottom ? y : extent->bottom;
}

/* All 16.16. */
static void add(struct touched *touched, fix16 left, fix16 top, fix16 right, fix16 bottom)
{
    struct rectangle box;

    if (right < left)
        return;
    box.left = left >> 16;
    box.top = top >> 16;
    box.right = (right >> 16) + 1;
    box.bottom = (bottom >> 16) + 1;
    touched_add(touched, &box);
}

void touched_vertices(struct touched *touched, const struct vertex *v, int32 count)
{
    struct extent extent;

    begin(&extent);
    for (; count > 0; count--, v++)
        include(&extent, v->x, v->y);
    add(touched, extent.left, extent.top, extent.right, extent.bottom);
}

/* Returns x or y of a mesh_place, 16.16, up to a sixteenth of a pixel too low. */
static fix16 placed_at(int32 place)
{
    return (place - SNAPPED_ONE) << (16 - SNAPPED_BITS);
}

/* Adds the places that are marked and in range; returns how many marked ones are not. */
static int32 add_places(struct touched *touched, const struct mesh_place *place, const uint8 *mark, uint32 points)
{
    struct extent extent;
    int32 off = 0;

    begin(&extent);
    for (; points; points--, mark++, place++) {
        const int32 both = place->place;        /* x is its upper word, and decides */

        if (!*mark)
            continue;
        if (both >= 0)
            include(&extent, both, (int16)both);
        else
            off++;
    }
    if (extent.right >= 0)
        add(touched, placed_at(extent.left >> 16), placed_at(extent.top), placed_at(extent.right >> 16),
            placed_at(extent.bottom));
    return off;
}

/* Adds the points inside all borders that are marked; with places, those that have none. */
static void add_points(struct touched *touched, const struct mesh_placed *placed, const struct mesh_place *place,
                       const uint8 *mark)
{
    const struct mesh_point *p = placed->points;
    struct extent extent;

    begin(&extent);
    for (uint32 points = placed->mesh->points; points; points--, mark++, p++) {
        const int32 is_placed = place && place++->place >= 0;

        if (*mark && !is_placed && !p->outside)
            include(&extent, p->screen_x, p->screen_y);
    }
    add(touched, extent.left, extent.top, extent.right, extent.bottom);
}

void touched_instance(struct touched *touched, const struct mesh_placed *placed, const uint8 *marks)
{
    const struct mesh_place *const places = placed->view16 ? placed->places : 0;

    if (!places || add_places(touched, places, marks, placed->mesh->points))
        add_points(touched, placed, places, marks);
}
