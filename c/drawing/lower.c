#include "drawing/lower.h"

#include "drawing/parts/rule.h"
#include "polygon/counts.h"

#define ONE_PIXEL 65536

static int32 is_beyond(fix16 value, uint32 far)
{
    return (uint32)value + far >= 2 * far;
}

/* Returns 1 if all vertices are beyond the same side of the frame: by a whole pixel on the sides
   where rounding of edges could lead inside. Returns 0 if a coordinate may be out of range, so that
   the set-up refuses it: the texels of a map are up to 128 times s. */
static int32 is_outside(const struct setup *s)
{
    enum { LEFT = 1, RIGHT = 2, ABOVE = 4, BELOW = 8 };
    const uint32 far = (uint32)POLYGON_FAR << 16;
    uint32 far_texel = s->material->map && s->material->map->scale > 65536 ? far >> 7 : far;
    fix16 right = (s->frame->width + 1) << 16, below = s->frame->height << 16;
    const struct vertex *v = s->given;
    uint32 sides = LEFT | RIGHT | ABOVE | BELOW;

    for (int32 i = s->count; i > 0; i--, v++) {
        if (v->x >= -ONE_PIXEL)
            sides &= ~(uint32)LEFT;
        if (v->x < right)
            sides &= ~(uint32)RIGHT;
        if (v->y >= -ONE_PIXEL)
            sides &= ~(uint32)ABOVE;
        if (v->y < below)
            sides &= ~(uint32)BELOW;
        if (!sides || is_beyond(v->x, far) || is_beyond(v->y, far)
            || is_beyond(v->s, far_texel) || is_beyond(v->t, far_texel))
            return 0;
    }
    return 1;
}

int32 lower_to_nothing(struct setup *s)
{
    if (!RULE_IS_ON(s, OUTSIDE) || !is_outside(s))
        return 0;
    RULE_APPLIES(s, OUTSIDE);
    return 1;
}

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

int32 lower_to_no_clamp(struct setup *s, int32 leaves_range)
{
    if (!RULE_IS_ON(s, INSIDE_RANGE) || leaves_range)
        return 0;
    RULE_APPLIES(s, INSIDE_RANGE);
    return 1;
}
