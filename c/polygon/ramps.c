#include "polygon/ramps.h"

#include "polygon/texturing.h"

void ramps_make(struct ramp *ramp, const struct edge *edge, int32 count)
{
    for (; count > 0; count--, ramp++, edge++) {
        struct edge along = *edge;

        /* Half a unit a line, and one each for a truncated product and quotient. */
        uint32 raise = (uint32)(edge->lines + 1) / 2 + 2;

        texturing_along(&along);
        ramp->lines = edge->lines;
        ramp->x = edge_x(edge);
        ramp->dx = edge_slope(edge);
        ramp->u = along.u + raise;
        ramp->v = along.v + raise;
        ramp->du = along.du;
        ramp->dv = along.dv;
    }
}
