#include "drawing/lower.h"

#include "drawing/dithered.h"
#include "drawing/generated.h"
#include "drawing/material.h"
#include "perspective/tolerance.h"
#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/shading.h"

#define ONE_PIXEL 65536

/* A rule is a line: its name, the kind of span it lowers, the result and the condition. Later lines
   may lower the result further. */
#define LOWER(rule, from, to, condition) LOWER_TO(rule, from, SPAN_##to, condition)
#define LOWER_TO(rule, from, to, condition) \
    if (kind == SPAN_##from && (condition) && RULE_IS_ON(s, rule)) { \
        RULE_APPLIES(s, rule); \
        kind = to; \
    }

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

/* Returns 1 if a field of all vertices is equal except in its `lowest` low bits. value: the first
   vertex's field. */
static int32 is_equal(const fix16 *value, int32 count, int32 lowest)
{
    int32 first = *value >> lowest;

    while (--count > 0) {
        value += VERTEX_FIELDS;
        if (*value >> lowest != first)
            return 0;
    }
    return 1;
}

int32 lower_w_is_constant(const struct setup *s)
{
    return is_equal(&s->given->w, s->count, 0);
}

/* No pixel has a level or a shade beyond those of the vertices. */
static int32 has_one_level(const struct setup *s)
{
    return is_equal(&s->given->shade, s->count, LEVEL_BITS);
}

static int32 has_one_shade(const struct setup *s)
{
    return is_equal(&s->given->shade, s->count, 16);
}

static int32 level(const struct setup *s)
{
    return s->given->shade >> LEVEL_BITS;
}

int32 lower_to_nothing(struct setup *s)
{
    if (!RULE_IS_ON(s, OUTSIDE) || !is_outside(s))
        return 0;
    RULE_APPLIES(s, OUTSIDE);
    return 1;
}

void lower_by_vertices(struct setup *s)
{
    const struct material *m = s->material;
    enum span_kind kind = s->kind;

    if (kind == SPAN_GENERATED) {
        if (!generated_may_draw(s))
            kind = SPAN_AFFINE_ADDX_WRAP;
    } else if (kind != SPAN_AFFINE_ADDX_WRAP) {
        LOWER(EQUAL_SHADES, GOURAUD, FILL, has_one_shade(s))
        LOWER(EQUAL_LEVELS, LIT_GOURAUD, LIT_WRAP, has_one_level(s))
        LOWER(NO_LIGHT, LIT_WRAP, FILL, level(s) == 0 && m->light && m->light->dark)
        LOWER(FULL_LIGHT, LIT_WRAP, AFFINE_ADDX_WRAP,
              level(s) == LIGHT_LEVELS - 1 && m->light && m->light->full)
    }
    if (kind == SPAN_AFFINE_ADDX_WRAP)
        kind = lower_affine(m, s->form);
    s->affine = kind;
    if (m->perspective && kind != SPAN_FILL) {
        kind = SPAN_PERSPECTIVE;
        LOWER_TO(CONSTANT_W, PERSPECTIVE, s->affine, lower_w_is_constant(s))
        LOWER_TO(TOLERANCE, PERSPECTIVE, s->affine, m->tolerance && tolerance_is_flat(s))
    }
    s->kind = kind;
}

void lower_by_planes(struct setup *s)
{
    s->setting = (enum perspective)s->material->perspective;
    s->level = LEVEL_NOTHING;
    if (RULE_IS_ON(s, COARSER) && s->material->tolerance && tolerance_is_coarser(s))
        RULE_APPLIES(s, COARSER);
}

void lower_by_steps(struct setup *s)
{
    const struct span_plan *span = &s->span;
    int32 width = s->box.right - s->box.left;
    enum span_kind kind = s->kind;

    if (kind == SPAN_AFFINE_ADDX_WRAP) {
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
    } else if (kind == SPAN_LIT_WRAP) {
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

int32 lower_to_no_clamp(struct setup *s, int32 leaves_range)
{
    if (!RULE_IS_ON(s, INSIDE_RANGE) || leaves_range)
        return 0;
    RULE_APPLIES(s, INSIDE_RANGE);
    return 1;
}
