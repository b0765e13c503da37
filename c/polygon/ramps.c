#include "polygon/ramps.h"

#include "polygon/texturing.h"

void ramps_make(struct ramp *ramp, const struct edge *edge, int32 count)
{
    for (; count > 0; count--, ramp++, edge++) {
        struct edge along = *edge;

        texturing_along(&along);
        ramp->lines = edge->lines;
        ramp->x = edge_x(edge);
        ramp->dx = edge_slope(edge);
        ramp->u = along.u;
        ramp->v = along.v;
        ramp->du = along.du;
        ramp->dv = along.dv;
    }
}
