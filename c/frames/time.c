#include "frames/frames.h"

#include "system/system.h"

/* Longest time for one frame, in units of 92 ms: 60 s, a thousand times that of a polygon. */
#define FRAME_LIMIT 650

enum polygon_result scene_time(struct renderer *renderer, struct scene *scene, int32 number,
                               uint32 *ticks)
{
    enum polygon_result result;
    uint32 taken;

    quiet_enter();
    if (ticks)
        clock_wait();
    clock_start(FRAME_LIMIT);
    result = scene_draw(renderer, scene, number);
    taken = clock_stop();
    if (ticks)
        *ticks = taken;
    quiet_leave();
    return result;
}
