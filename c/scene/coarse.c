#include "scene/coarse.h"

enum { SHOWN_WIDTH = 8, SHOWN_HEIGHT = 1 };     /* what a screen's frames are multiples of */

int32 scene_has_coarse(const struct scene *scene)
{
    const struct scene_header *h = scene->header;

    return h->instances && !h->objects && !h->units && !h->pipes && h->pixel_width == 1 && h->pixel_height == 1
        && h->width % (2 * SHOWN_WIDTH) == 0 && h->height % (2 * SHOWN_HEIGHT) == 0 && h->guard > GUARD_MIN;
}

/* by: 1 to pixels twice as large, -1 back. */
static int32 scaled(int32 value, int32 by)
{
    return by > 0 ? value >> 1 : value << 1;
}

void scene_set_coarse(struct scene *scene, int32 is_coarse)
{
    struct scene_header *h = (struct scene_header *)scene->header;
    const int32 by = is_coarse ? 1 : -1;

    if (scene->is_coarse == is_coarse)
        return;
    scene->is_coarse = (uint8)is_coarse;
    h->width = scaled(h->width, by);
    h->height = scaled(h->height, by);
    h->pixel_width = scaled(h->pixel_width, -by);
    h->pixel_height = scaled(h->pixel_height, -by);
    h->guard -= (uint32)by;
    if (scene->depths) {
        scene->depths->aside.width = scene->depths->aside.pitch = h->width;
        scene->depths->aside.height = h->height;
    }
}
