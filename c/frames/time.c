#include "frames/frames.h"

#include "frames/time.h"
#include "system/system.h"

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
