#include "screen/planar.h"

static void fill(uint8 *row, const struct planar_plan *plan, uint32 dots)
{
    int32 rows = plan->rows;

    do {
        uint32 *to = (uint32 *)row;
        int32 longs = plan->width * HAM8_DOTS >> 5;

        do {
            *to++ = dots;
        } while (--longs > 0);
        row += plan->row_pitch;
    } while (--rows > 0);
}

void ham8_control(const struct planar_plan *plan)
{
    uint8 *planes = plan->planes;

    fill(planes, plan, HAM8_PLANE_0);
    fill(planes + plan->plane_pitch, plan, HAM8_PLANE_1);
}
