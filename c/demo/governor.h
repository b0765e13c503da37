/* Which step of a part is drawn, so that frames come in time.

   Steps go from the best, 0, to the cheapest; the best is begun with. A late frame counts two, one
   in time takes one back; at GOVERNOR_LATE the next cheaper step is taken. How much longer a frame
   of the step that was left took is kept, and that step is taken again only after GOVERNOR_CALM
   frames in time of which the longest, so much longer, would leave an eighth of the time. So a load
   that stays within an eighth of itself changes the step in one direction alone. */
#ifndef GOVERNOR_H
#define GOVERNOR_H

#include "compiler.h"

enum governor_constants {
    GOVERNOR_STEPS = 8,         /* at most */
    GOVERNOR_LATE = 6,
    GOVERNOR_CALM = 25,         /* frames: a second */
    GOVERNOR_ROOM = 7,          /* eighths of the budget */
    GOVERNOR_RATIO_BITS = 8,
    GOVERNOR_WORK_MAX = 1 << 22 /* ticks; longer frames count as so long */
};

struct governor {
    int32 step, steps;
    uint32 budget;              /* ticks a frame may take, less than GOVERNOR_WORK_MAX */
    int32 late;                 /* two a frame that was, less one each that was not */
    int32 calm;                 /* frames in time in a row, of this step */
    uint32 most;                /* ticks of the longest of these */
    uint32 left;                /* ticks of the last frame of the step above, or 0: known already */
    uint32 ratio[GOVERNOR_STEPS];       /* of a frame of this step to one of the next: 24.8, rounded
                                           down, less than 16 */
};

void governor_start(struct governor *governor, int32 steps, uint32 budget);

/* A frame of the present step took so many ticks; returns the next one's step. */
int32 governor_next(struct governor *governor, uint32 work);

#endif
