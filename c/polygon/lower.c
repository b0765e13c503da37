#include "polygon/lower.h"

#include "polygon/material.h"
#include "polygon/shading.h"
#include "polygon/tolerance.h"

#define ONE_PIXEL 65536

/* Conditions, in the order of the rules below. */

/* By a whole pixel where edges are rounded, so that no rounding leads inside. */
static int32 is_outside(struct setup *s)
{
    enum { LEFT = 1, RIGHT = 2, ABOVE = 4, BELOW = 8 };
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
        if (!sides)
            return 0;
    }
    return 1;
}

/* Whether a field of struct vertex, given by its first value, has one upper part all over. */
static int32 is_equal(const fix16 *value, int32 count, int32 cut)
{
    int32 first = *value >> cut;

    while (--count > 0) {
        value += sizeof(struct vertex) / sizeof *value;
        if (*value >> cut != first)
            return 0;
    }
    return 1;
}

/* No pixel has a level or shade beyond those of the vertices. */
static int32 levels_are_equal(struct setup *s)
{
    return is_equal(&s->given->shade, s->count, LEVEL_BITS);
}

static int32 shades_are_equal(struct setup *s)
{
    return is_equal(&s->given->shade, s->count, 16);
}

static int32 light_is_full(struct setup *s)
{
    return s->given->shade >> LEVEL_BITS == LIGHT_LEVELS - 1 && s->material->light
        && s->material->light->full;
}

static int32 light_is_dark(struct setup *s)
{
    return !(s->given->shade >> LEVEL_BITS) && s->material->light && s->material->light->dark;
}

int32 lower_w_is_constant(struct setup *s)
{
    return is_equal(&s->given->w, s->count, 0);
}

static int32 is_within_tolerance(struct setup *s)
{
    return s->material->tolerance && tolerance_is_flat(s);
}

static int32 may_be_coarser(struct setup *s)
{
    return s->material->tolerance && tolerance_is_coarser(s);
}

/* No edge can lie outside the frame's columns. */
static int32 is_inside_columns(struct setup *s)
{
    return s->outline_sides->x_low >= 0
        && s->outline_sides->x_high + EDGE_ERROR <= s->frame->width << 16;
}

static int32 is_inside_range(struct setup *s)
{
    return !material_leaves_range(s);
}

/* Whether a step is 0, and whether one is small enough for the spans that step u or v
   alone: 62 texels a pixel, for 1,024 pixels. Both as the map repeats, modulo 256. */
static int32 is_still(fix16 step)
{
    return !((uint32)step << 8);
}

static int32 is_slow(fix16 step)
{
    const uint32 most = (uint32)62 << 24;

    return ((uint32)step << 8) + most <= 2 * most;
}

static int32 v_stands_still(struct setup *s)
{
    return is_still(s->span.dvdx) && is_slow(s->span.dudx);
}

static int32 u_stands_still(struct setup *s)
{
    return is_still(s->span.dudx) && is_slow(s->span.dvdx);
}

static int32 v_wraps_once_at_most(struct setup *s)
{
    return !s->texturing.wraps;
}

/* Each rule: from what, to what, where. `from` may have several, which follow one another;
   the first that applies is taken, and those of what it leads to are looked at next. */
static const struct {
    uint8 from, to;
    int32 (*applies)(struct setup *s);
} rules[RULES] = {
    /* before anything is made */
    [RULE_OUTSIDE] = {WORK_POLYGON, WORK_NONE, is_outside},
    /* by the vertices */
    [RULE_EQUAL_LEVELS] = {SPAN_LIT_GOURAUD, SPAN_LIT_WRAP, levels_are_equal},
    [RULE_FULL_LIGHT] = {SPAN_LIT_WRAP, SPAN_AFFINE_ADDX_WRAP, light_is_full},
    [RULE_NO_LIGHT] = {SPAN_LIT_WRAP, SPAN_FILL, light_is_dark},
    [RULE_EQUAL_SHADES] = {SPAN_GOURAUD, SPAN_FILL, shades_are_equal},
    [RULE_CONSTANT_W] = {SPAN_PERSPECTIVE, SPAN_AFFINE_ADDX_WRAP, lower_w_is_constant},
    [RULE_TOLERANCE] = {SPAN_PERSPECTIVE, SPAN_AFFINE_ADDX_WRAP, is_within_tolerance},
    /* by the planes of a perspective */
    [RULE_COARSER] = {SPAN_PERSPECTIVE, SPAN_PERSPECTIVE, may_be_coarser},
    /* by edges and steps */
    [RULE_INSIDE_FRAME] = {WORK_SCISSOR, WORK_NONE, is_inside_columns},
    [RULE_INSIDE_RANGE] = {WORK_HOLD, WORK_NONE, is_inside_range},
    [RULE_STILL_V] = {SPAN_AFFINE_ADDX_WRAP, SPAN_AFFINE_ROW, v_stands_still},
    [RULE_STILL_U] = {SPAN_AFFINE_ADDX_WRAP, SPAN_AFFINE_COLUMN, u_stands_still},
    [RULE_NO_WRAP] = {SPAN_AFFINE_ADDX_WRAP, SPAN_AFFINE_ADDX, v_wraps_once_at_most},
    [RULE_NO_WRAP_LIT] = {SPAN_LIT_WRAP, SPAN_LIT, v_wraps_once_at_most}
};

/* Where the rules that lead from a kind begin, at either stage. */
enum stage { BY_VERTICES, BY_STEPS, STAGES };

static const uint8 first_rule[SPAN_PERSPECTIVE + 1][STAGES] = {
    [SPAN_GOURAUD] = {RULE_EQUAL_SHADES},
    [SPAN_LIT_GOURAUD] = {RULE_EQUAL_LEVELS},
    [SPAN_LIT_WRAP] = {RULE_FULL_LIGHT, RULE_NO_WRAP_LIT},
    [SPAN_PERSPECTIVE] = {RULE_CONSTANT_W},
    [SPAN_AFFINE_ADDX_WRAP] = {0, RULE_STILL_V}
};

static int32 applies(struct setup *s, enum rule rule)
{
    if (s->off >> rule & 1 || !rules[rule].applies(s))
        return 0;
    if (s->counts)
        s->counts->rules[rule]++;
    return 1;
}

int32 lower_leaves_out(struct setup *s, enum rule rule)
{
    return applies(s, rule);
}

/* Follows the rules of a stage from s->kind down. */
static void follow(struct setup *s, enum stage stage)
{
    uint32 rule = first_rule[s->kind][stage];

    while (rule && rule < RULES && rules[rule].from == s->kind) {
        if (applies(s, (enum rule)rule)) {
            s->kind = (enum span_kind)rules[rule].to;
            rule = first_rule[s->kind][stage];
        } else {
            rule++;
        }
    }
}

enum span_kind lower_affine(const struct material *material, enum form form)
{
    return material->gradients == GRADIENTS_SCANLINE ? SPAN_AFFINE_SCANLINE
         : form == FORM_SWAP ? SPAN_AFFINE_SWAP
         : form == FORM_C ? SPAN_AFFINE_C
         : SPAN_AFFINE_ADDX_WRAP;
}

/* What draws anything a mapper may be asked for, with 1 and 2 bytes a pixel. */
static const uint8 asked[MAPPER_KINDS][2] = {
    [MAPPER_FLAT] = {SPAN_FILL, SPAN_FILL_16},
    [MAPPER_GOURAUD] = {SPAN_GOURAUD},
    [MAPPER_AFFINE] = {SPAN_AFFINE_ADDX_WRAP},
    [MAPPER_ARBITRARY] = {SPAN_ARBITRARY},
    [MAPPER_TILED] = {SPAN_TILED},
    [MAPPER_COLUMNS] = {SPAN_COLUMNS, SPAN_COLUMNS_16},
    [MAPPER_GENERATED] = {SPAN_GENERATED},
    [MAPPER_LIT] = {SPAN_LIT_WRAP},
    [MAPPER_LIT_GOURAUD] = {SPAN_LIT_GOURAUD}
};

void lower_by_vertices(struct setup *s)
{
    const struct material *material = s->material;

    s->kind = material->perspective ? SPAN_PERSPECTIVE
            : (enum span_kind)asked[material->mapper][s->frame->pixel_bytes - 1];
    follow(s, BY_VERTICES);
    if (s->kind == SPAN_AFFINE_ADDX_WRAP)
        s->kind = lower_affine(material, s->form);
}

void lower_by_planes(struct setup *s)
{
    s->setting = (enum perspective)s->material->perspective;
    s->straight = 0;
    applies(s, RULE_COARSER);
}

void lower_by_steps(struct setup *s)
{
    follow(s, BY_STEPS);
}
