#include "perspective/light.h"

#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/shading.h"

void light_keep_lines(const struct setup *s, const struct logarithm_line *taken)
{
    struct scanline *line = s->edges.lines;

    for (int32 i = s->span.count; i > 0; i--, line++, taken++)
        line->start1 = (uint16)(taken->n < 0 ? line->last : line->left + taken->n);
}

void light_restore_lines(const struct setup *s)
{
    struct scanline *line = s->edges.lines;

    for (int32 i = s->span.count; i > 0; i--, line++)
        line->last = (int16)line->start1;
}

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
