#include "show/governor.h"

void governor_start(struct governor *governor, int32 steps)
{
    governor->step = 0;
    governor->steps = steps;
    governor->late = governor->calm = 0;
    governor->most = governor->left = 0;
}

static void change(struct governor *governor, int32 by, uint32 left)
{
    governor->step += by;
    governor->late = governor->calm = 0;
    governor->most = 0;
    governor->left = left;
}

/* Returns 1 if the better step would have been in time for all these calm frames. */
static int32 has_room(const struct governor *governor)
{
    return governor->step > 0
        && governor->most * governor->ratio[governor->step - 1] >> GOVERNOR_RATIO_BITS
           <= governor->budget[governor->step - 1] / 8 * GOVERNOR_ROOM;
}

int32 governor_next(struct governor *governor, uint32 work)
{
    if (work > GOVERNOR_WORK_MAX)
        work = GOVERNOR_WORK_MAX;
    if (governor->left) {       /* the quotient is below 2^30, has_room's product below 2^32 */
        uint32 ratio = (governor->left << GOVERNOR_RATIO_BITS) / (work | 1);

        governor->ratio[governor->step - 1] = ratio < 4096 ? ratio : 4095;
        governor->left = 0;
    }
    if (work > governor->budget[governor->step]) {
        governor->late += 2;
        governor->calm = 0;
        governor->most = 0;
        if (governor->late >= GOVERNOR_LATE && governor->step < governor->steps - 1)
            change(governor, 1, work);
        return governor->step;
    }
    if (governor->late)
        governor->late--;
    governor->calm++;
    if (work > governor->most)
        governor->most = work;
    if (governor->calm == GOVERNOR_CALM) {
        if (has_room(governor))
            change(governor, -1, 0);
        governor->calm = 0;
        governor->most = 0;
    }
    return governor->step;
}
