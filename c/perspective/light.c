#include "perspective/light.h"

#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/shading.h"

void light_draw(struct setup *s, uint32 *shades)
{
    const enum span_kind kind = light_kind(s);

    if (s->counts)
        s->counts->pixels[kind] += lines_pixels(s->edges.lines, s->span.count);
    if (s->counts && s->renderer->only_counts)
        return;
    if (kind == SPAN_LIGHT_GOURAUD)
        shading_lines(s, shades);
    kind_spans[kind](&s->span);
}
