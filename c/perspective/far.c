#include "perspective/far.h"

/* By log2 of the greatest step, of q 2^31, in pieces of one pixel. */
#define LENGTHS(every) \
    {1 << ((every) - 8), 1 << ((every) - 6), 1 << ((every) - 4), 1 << ((every) - 2)}

/* The last is for every8 where a tolerance has chosen it: it allows no more than 8 pixels. */
const struct far_lengths far_lengths[3] = {
    LENGTHS(FAR_EVERY16),
    LENGTHS(FAR_EVERY8),
    {0, 1 << (FAR_EVERY8 - 6), 1 << (FAR_EVERY8 - 4), 1 << (FAR_EVERY8 - 2)}
};

struct far_line *far_make_lines(const struct setup *s, uint32 q, int32 dqdx, int32 dqdy, int32 has_lines)
{
    const int32 leftwards = dqdx < 0;
    union {
        struct far_place place;     /* both begin with it */
        struct far_lines lines;
        struct far_edges edges;
    } to;

    to.place.lines = (struct far_line *)s->scratch->room;
    to.place.row = s->span.row;
    to.place.pitch = s->span.pitch;
    to.place.q = q - (uint32)dqdx * (uint32)(s->perspective->left + EDGE_BIAS + leftwards);
    to.place.dqdx = dqdx;
    to.place.dqdy = dqdy;
    if (has_lines) {
        to.lines.from = s->edges.lines;
        to.lines.count = s->span.count;
        to.lines.leftwards = leftwards;
        lines_far(&to.lines);
    } else if (leftwards) {
        to.edges.far = s->edges.right;
        to.edges.near = s->edges.left;
        to.edges.fars = s->edges.rights;
        to.edges.nears = s->edges.lefts;
        edges_far(&to.edges);
    } else {
        to.edges.far = s->edges.left;
        to.edges.near = s->edges.right;
        to.edges.fars = s->edges.lefts;
        to.edges.nears = s->edges.rights;
        edges_far(&to.edges);
    }
    return to.place.lines;
}
