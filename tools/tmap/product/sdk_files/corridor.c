/* Walks down a corridor in perspective, 160x128 pixels of 2x2, until Escape is pressed: cursor up and down change the
   speed. Then it saves a frame at the place LAST as corridor.chunky. Nothing is clipped here: the walls begin at depth
   1, beyond the frame's borders. */
#include "stage.h"

enum { WIDTH = 160, HEIGHT = 128, FOCUS = 100, FAR_WALL = 8, LAST = 48 };

static uint16 reciprocals[FAR_COUNT];

/* Half the corridor's width and height: x and y of its four edges at depth 1. */
static const int8 edges[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };

static void set_corner(struct vertex *corner, int32 edge, int32 depth, int32 s, int32 t)
{
    corner->x = (WIDTH / 2 << 16) + (edges[edge][0] * FOCUS << 16) / depth;
    corner->y = (HEIGHT / 2 << 16) + (edges[edge][1] * FOCUS << 16) / depth;
    corner->s = s << 16;
    corner->t = t << 16;
    corner->w = depth << 16;
}

/* Draws the four sides and the end; place: texels that have been walked. */
static void draw(int32 place)
{
    static struct vertex corners[4];
    static struct polygon polygon;

    polygon_set(&polygon, corners, 4, PLANAR_ALL);
    for (int32 side = 0; side < 4; side++) {
        const int32 next = (side + 1) & 3, far = place + 64 * (FAR_WALL - 1);

        set_corner(&corners[0], side, 1, 0, place);
        set_corner(&corners[1], next, 1, 128, place);
        set_corner(&corners[2], next, FAR_WALL, 128, far);
        set_corner(&corners[3], side, FAR_WALL, 0, far);
        polygon_draw(&stage_renderer, &polygon, &stage_material);
    }
    for (int32 k = 0; k < 4; k++)
        set_corner(&corners[k], k, FAR_WALL, k == 1 || k == 2 ? 128 : 0, k > 1 ? 128 : 0);
    polygon_draw(&stage_renderer, &polygon, &stage_material);
}

int main(void)
{
    int32 field = 0, before = 0, place = 0, speed = 1;

    if (!stage_open(WIDTH, HEIGHT, 2))
        return 20;
    stage_material.perspective = PERSPECTIVE_EVERY16;
    stage_renderer.reciprocals = reciprocals_make(reciprocals);
    while (field >= 0) {
        const uint32 key = stage_key();

        speed += (key == KEY_UP) - (key == KEY_DOWN);
        place = (place + speed * (field - before)) & 255;       /* the map repeats */
        before = field;
        draw(place);
        field = stage_show(key);
    }
    draw(LAST);
    return stage_close("corridor.chunky");
}
