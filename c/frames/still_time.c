#include "frames/still.h"
#include "frames/time.h"
#include "system/system.h"
#include "system/text.h"

void still_time(void)
{
    uint32 ticks = 0;

    if (clock_open()) {
        quiet_enter();
        clock_wait();
        clock_start(FRAME_LIMIT);
        still_draw();
        ticks = clock_stop();
        quiet_leave();
        clock_close();
    }
    text_number((int32)ticks);
    text_print();
}
