#include "polygon/ramps.h"

#include "polygon/texturing.h"

void ramps_make(struct ramp *ramp, const struct edge *edge, const struct side_edge *from,
                int32 count)
{
    for (; count > 0; count--, ramp++, edge++, from++) {
        struct edge along;

        along.lines = ramp->lines = edge->lines;
        texturing_along(&along, from);
        ramp->x = edge_x(from);
        ramp->dx = edge_slope(from);
        ramp->u = along.u;
        ramp->v = along.v;
        ramp->du = along.du;
        ramp->dv = along.dv;
    }
}
