/* Rules by the steps of spans that are not affine ones of a byte a pixel. */
#include "drawing/dithered.h"
#include "drawing/lower.h"
#include "drawing/rule.h"
#include "polygon/counts.h"
#include "polygon/kind.h"

void lower_others(struct setup *s)
{
    const struct span_plan *span = &s->span;
    int32 width = s->box.right - s->box.left;
    enum span_kind kind = s->kind;

    if (kind == SPAN_LIT_WRAP) {
        LOWER(NO_WRAP_LIT, LIT_WRAP, LIT, !s->texturing.wraps)
        LOWER(SHORT_LIT, LIT, LIT_SHORT, width <= SHORT_LIT)
        LOWER(SHORT_LIT_WRAP, LIT_WRAP, LIT_SHORT_WRAP, width <= SHORT_LIT_WRAP)
    } else if (kind == SPAN_KEYED_WRAP) {
        LOWER(STILL_V_KEYED, KEYED_WRAP, KEYED_ROW, STEP_IS_STILL(span->dvdx) && STEP_IS_SLOW(span->dudx))
        LOWER(NO_WRAP_KEYED, KEYED_WRAP, KEYED, !s->texturing.wraps)
    } else if (kind == SPAN_GOURAUD) {
        LOWER(SHORT_GOURAUD, GOURAUD, GOURAUD_SHORT, width <= SHORT_GOURAUD)
    } else if (kind == SPAN_AFFINE_16_WRAP) {
        LOWER(STILL_V, AFFINE_16_WRAP, AFFINE_16_ROW,
              STEP_IS_STILL(span->dvdx) && STEP_IS_SLOW(span->dudx))
        LOWER(NO_WRAP, AFFINE_16_WRAP, AFFINE_16, !s->texturing.wraps)
        LOWER(UNIT_STEP, AFFINE_16_ROW, AFFINE_16_COPY,
              STEP_IS_STILL(span->dudx - 65536) && width >= COPY_16_LEAST)
    } else if (kind == SPAN_AFFINE_32_WRAP) {
        LOWER(STILL_V, AFFINE_32_WRAP, AFFINE_32_ROW,
              STEP_IS_STILL(span->dvdx) && STEP_IS_SLOW(span->dudx))
        LOWER(NO_WRAP, AFFINE_32_WRAP, AFFINE_32, !s->texturing.wraps)
    } else if (s->material->mapper == MAPPER_DITHERED) {
        dithered_span(s);
        LOWER(NO_WRAP_DITHERED, DITHERED_WRAP, DITHERED, !s->texturing.wraps)
        LOWER(NO_WRAP_DITHERED, DITHERED_16_WRAP, DITHERED_16, !s->texturing.wraps)
        LOWER(NO_WRAP_DITHERED, DITHERED_32_WRAP, DITHERED_32, !s->texturing.wraps)
    }
    s->kind = kind;
}
