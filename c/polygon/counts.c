#include "polygon/counts.h"

void count_lines(const struct setup *s, enum span_kind kind)
{
    s->counts->polygons++;
    s->counts->pixels[kind] += lines_pixels(s->edges.lines, s->box.bottom - s->box.top);
}
