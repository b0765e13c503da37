/* Lowering: a polygon is drawn by the cheapest spans that give the same picture. lower.c has the
   rules, RULE_LIST of polygon/span_list.h their meaning. */
#ifndef LOWER_H
#define LOWER_H

#include "polygon/counts.h"
#include "polygon/kind.h"
#include "polygon/setup.h"

/* Returns non-zero if nothing is drawn; called before the set-up. */
int32 lower_to_nothing(struct setup *s);

/* Returns the affine kind for the material's gradients and a form. */
static inline enum span_kind lower_affine(const struct material *material, enum form form)
{
    return material->gradients == GRADIENTS_SCANLINE ? SPAN_AFFINE_SCANLINE
         : form == FORM_SWAP ? SPAN_AFFINE_SWAP
         : form == FORM_C ? SPAN_AFFINE_C
         : SPAN_AFFINE_ADDX_WRAP;
}

/* Sets s->kind to the material's kind of span. Returns non-zero if the vertices may allow a cheaper
   one. */
static inline int32 lower_asked(struct setup *s)
{
    const struct material *m = s->material;
    const struct mapper_traits *mapper = &mappers[m->mapper];

    s->kind = (enum span_kind)mapper->kind[s->frame->pixel_bytes >> 1];
    if (s->kind == SPAN_AFFINE_ADDX_WRAP && !m->perspective)
        s->kind = lower_affine(m, s->form);
    return m->perspective || mapper->is & MAPPER_BY_VERTICES;
}

/* Lowers s->kind by the vertices. */
void lower_by_vertices(struct setup *s);

/* SPAN_PERSPECTIVE: sets s->setting to the material's perspective and s->straight to 0, then lowers
   them by the planes. */
void lower_by_planes(struct setup *s);

/* Lowers s->kind by the box and the steps of texturing; not with GRADIENTS_SCANLINE. */
void lower_by_steps(struct setup *s);

/* The same for spans that are not affine ones of a byte a pixel. */
void lower_others(struct setup *s);

/* Returns non-zero if lines need not be cut to the frame's columns. */
static inline int32 lower_to_no_scissor(struct setup *s)
{
    if (!RULE_IS_ON(s, INSIDE_FRAME) || s->outline_sides->x_low < 0
        || s->outline_sides->x_high + EDGE_ERROR > s->frame->width << 16)
        return 0;
    RULE_APPLIES(s, INSIDE_FRAME);
    return 1;
}

int32 lower_w_is_constant(const struct setup *s);

#endif
