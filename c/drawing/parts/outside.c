/* The rule that nothing is drawn outside the frame. */
#include "drawing/lower.h"
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
