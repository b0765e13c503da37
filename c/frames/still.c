#include "frames/still.h"

void still_run(const struct still_run *run)
{
    if (run->count == 1)
        polygon_draw(run->renderer, run->polygons, run->material);
    else
        polygons_draw(run->renderer, run->polygons, run->count, run->material);
}
