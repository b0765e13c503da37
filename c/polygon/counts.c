#include "polygon/counts.h"

void count_lines(const struct setup *s, enum span_kind kind)
{
    s->counts->polygons++;
    s->counts->pixels[kind] += lines_pixels(s->edges.lines, s->box.bottom - s->box.top);
}

int32 count_unsure(const struct setup *s)
{
    if (s->counts)
        s->counts->unsure++;
    return 0;
}

uint32 counts_drawn(const struct draw_counts *counts)
{
    uint32 pixels = 0;

    for (int32 kind = 0; kind < SPAN_KINDS; kind++)
        if (kind != SPAN_LIGHT && kind != SPAN_LIGHT_GOURAUD)
            pixels += counts->pixels[kind];
    return pixels;
}
