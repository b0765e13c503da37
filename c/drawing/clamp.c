#include "drawing/clamp.h"

#include "drawing/lower.h"
#include "drawing/material.h"

/* Returns a step, made two units slower if it falls: the start of a line may be moved one unit
   below the far border, and u is above the exact value again a pixel on. */
static fix16 slower(fix16 step)
{
    return step >= 0 ? step : step < -2 ? step + 2 : 0;
}

void clamp_lines(struct setup *s)
{
    struct clamp_plan clamp;
    int32 leaves = material_leaves_range(s);

    if (lower_to_no_clamp(s, leaves))
        return;
    material_range(&clamp, s);
    clamp.lines = (struct scanline *)s->span.lines;
    clamp.count = s->span.count;
    clamp.dudx = leaves ? slower(s->span.dudx) : s->span.dudx;
    clamp.dvdx = leaves ? slower(s->span.dvdx) : s->span.dvdx;
    edge_clamp(&clamp);
    s->span.dudx = clamp.dudx;
    s->span.dvdx = clamp.dvdx;
}
