/* Rules by the vertices, and by the planes of perspective. */
#include "drawing/generated.h"
#include "drawing/lower.h"
#include "drawing/rule.h"
#include "drawing/parts/named.h"
#include "perspective/tolerance.h"
#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/shading.h"

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
    s->setting = (enum perspective)perspective_named[s->material->perspective];
    s->level = LEVEL_NOTHING;
    if (RULE_IS_ON(s, COARSER) && s->material->tolerance && tolerance_is_coarser(s))
        RULE_APPLIES(s, COARSER);
}
