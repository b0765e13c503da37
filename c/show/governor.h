/* Chooses which of some steps frames are drawn with, so that they are ready in time.

   Steps go from the best, 0, with which it begins, to the cheapest. A late frame counts 2, a
   frame in time takes 1 back; at GOVERNOR_LATE the governor changes to the next cheaper step and
   keeps the ratio of the two steps' times. It goes back after GOVERNOR_CALM frames in time in a
   row, if the longest of them, times that ratio, would leave an eighth of the better step's budget. So a load
   that varies by less than a tenth changes the step in one direction only: the ratio is then too
   small by at most a tenth and its rounding, 1/256. */
#ifndef GOVERNOR_H
#define GOVERNOR_H

#include "compiler.h"

enum governor_constants {
    LINE_TICKS = 227,           /* colour clocks */
    FIELD_TICKS = 312 * LINE_TICKS,
    FIELD_BUDGET = FIELD_TICKS * 95 / 100,      /* all work is timed; a twentieth is left for the system's */
    GOVERNOR_STEPS = 8,         /* at most */
    GOVERNOR_LATE = 6,
    GOVERNOR_CALM = 25,         /* frames: a second */
    GOVERNOR_ROOM = 7,          /* eighths of the budget */
    GOVERNOR_RATIO_BITS = 8,
    GOVERNOR_WORK_MAX = 1 << 22 /* ticks; longer times are clamped to this */
};

struct governor {
    int32 step, steps;
    uint32 budget[GOVERNOR_STEPS];      /* ticks a frame of each step may take, less than 2^20 */
    int32 late;                 /* 2 for each late frame, less 1 for each frame in time */
    int32 calm;                 /* frames in time in a row, of this step, up to GOVERNOR_CALM */
    uint32 most;                /* ticks of the longest of these */
    uint32 left;                /* ticks of the better step's last frame; 0: the ratio is known */
    uint32 ratio[GOVERNOR_STEPS];       /* time of a frame of this step / of the next: 24.8, rounded
                                           down, less than 16 */
};

/* The budgets are set already. */
void governor_start(struct governor *governor, int32 steps);

/* Takes the ticks of a frame drawn with the current step; returns the next frame's step. */
int32 governor_next(struct governor *governor, uint32 work);

#endif
