#include "show/times.h"

#include "system/system.h"
#include "system/text.h"

#define NO_LIMIT 65535          /* of the clock: the watchdog is off */

uint32 times_show(struct screen *screen, const struct frame *frame, const struct touched *touched,
                  uint32 *ticks)
{
    const int32 is_merged = screen->between[0] != 0;
    uint32 since;

    clock_start(NO_LIMIT);
    if (!is_merged)
        screen_wait(screen);
    since = display_since();
    screen_show(screen, frame, touched);
    if (is_merged)              /* it has waited in the midst */
        since = display_since();
    *ticks = clock_stop();
    return since - screen->since;
}

void times_print(const struct frame_time *times, int32 count)
{
    for (; count; count--, times++) {
        text_add("drawn ");
        text_number((int32)times->drawing);
        text_add(" converted ");
        text_number((int32)times->showing);
        text_add(" field ");
        text_number((int32)times->shown);
        if (times->rung >= 0) {
            text_add(" rung ");
            text_number(times->rung);
        }
        text_print();
    }
}
