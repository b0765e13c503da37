/* What draws lines by reciprocals, which a program may leave out: drawing/parts/parts.h. */
#include "perspective/far.h"
#include "span/far.h"

far_routine *const far_spans[2][3][2] = {
    {{span_far_right, span_far_left},
     {span_far_right_coarse, span_far_left_coarse},
     {span_far_right_coarser, span_far_left_coarser}},
    {{span_far_even_right, span_far_even_left},
     {span_far_even_right_coarse, span_far_even_left_coarse},
     {span_far_even_right_coarser, span_far_even_left_coarser}}
};

void far_draw(const struct setup *s, const struct depth *depth, const struct far_way *way, struct far_line *lines)
{
    struct far_span span;

    far_span_find(&span, s, depth, way);
    span.lines = lines;
    far_spans[way->even][way->coarse][(int32)s->perspective->q.dx.hi < 0](&span);
}
