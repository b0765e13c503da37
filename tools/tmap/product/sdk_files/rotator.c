/* Turns and zooms a picture over the whole screen, 320x256 pixels, until Escape is pressed, then saves a frame at an
   eighth of a turn as rotator.chunky. */
#include "stage.h"

enum { WIDTH = 320, HEIGHT = 256, LAST = TURN / 8 };

static void draw(int32 angle)
{
    static struct vertex corners[4];
    static struct polygon polygon;
    const int32 size = (sine(2 * angle) >> 8) + 128;    /* texels a pixel, 1/128: 64 to 192 */
    const int32 c = size * (sine(angle + TURN / 4) >> 5), s = size * (sine(angle) >> 5);      /* 16.16 */

    for (int32 k = 0; k < 4; k++) {
        const int32 x = k == 1 || k == 2 ? WIDTH : 0, y = k > 1 ? HEIGHT : 0;

        corners[k].x = x << 16;
        corners[k].y = y << 16;
        corners[k].s = c * (x - WIDTH / 2) - s * (y - HEIGHT / 2);
        corners[k].t = s * (x - WIDTH / 2) + c * (y - HEIGHT / 2);
    }
    polygon_set(&polygon, corners, 4, PLANAR_ALL);
    polygon_draw(&stage_renderer, &polygon, &stage_material);
}

int main(void)
{
    int32 field = 0;

    if (!stage_open(WIDTH, HEIGHT, 1))
        return 20;
    for (; field >= 0; field = stage_show(stage_key()))
        draw(field / 4);
    draw(LAST);
    return stage_close("rotator.chunky");
}
