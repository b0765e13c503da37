#include "drawing/lower.h"

#include "drawing/rule.h"
#include "polygon/counts.h"

void lower_by_steps(struct setup *s)
{
    const struct span_plan *span = &s->span;
    int32 width = s->box.right - s->box.left;
    enum span_kind kind = s->kind;

    if (kind != SPAN_AFFINE_ADDX_WRAP) {
        lower_others(s);
        return;
    }
    LOWER(STILL_V, AFFINE_ADDX_WRAP, AFFINE_ROW,
          STEP_IS_STILL(span->dvdx) && STEP_IS_SLOW(span->dudx))
    LOWER(STILL_U, AFFINE_ADDX_WRAP, AFFINE_COLUMN,
          STEP_IS_STILL(span->dudx) && STEP_IS_SLOW(span->dvdx))
    if (kind == SPAN_AFFINE_ADDX_WRAP) {
        LOWER(NO_WRAP, AFFINE_ADDX_WRAP, AFFINE_ADDX, !s->texturing.wraps)
        LOWER(SHORT, AFFINE_ADDX, AFFINE_SHORT, width <= SHORT_AFFINE)
        LOWER(SHORT_WRAP, AFFINE_ADDX_WRAP, AFFINE_SHORT_WRAP, width <= SHORT_AFFINE_WRAP)
    } else {
        LOWER(UNIT_STEP, AFFINE_ROW, AFFINE_COPY,
              STEP_IS_STILL(span->dudx - 65536) && width >= COPY_LEAST)
        LOWER(SHORT_ROW, AFFINE_ROW, AFFINE_ROW_SHORT, width <= SHORT_AFFINE_ROW)
    }
    s->kind = kind;
}
