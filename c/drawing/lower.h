/* Lowering: a polygon is drawn by the least that gives the same picture. The rules are lines
   of lower.c, what they mean enum rule. */
#ifndef LOWER_H
#define LOWER_H

#include "polygon/setup.h"

/* Whether nothing is drawn: asked before the set-up. */
int32 lower_to_nothing(struct setup *s);

/* Makes s->kind what the material asks for; says whether its vertices may show that less
   will do. */
int32 lower_asked(struct setup *s);

/* Lowers s->kind by the vertices. */
void lower_by_vertices(struct setup *s);

/* SPAN_PERSPECTIVE: makes s->setting and s->straight what the material asks for, lowered by
   what the planes show. */
void lower_by_planes(struct setup *s);

/* Lowers s->kind by what box and texturing show; not with GRADIENTS_SCANLINE. */
void lower_by_steps(struct setup *s);

/* Whether lines need not be cut to the frame's columns, nor moved until u and v stay in their
   range. */
int32 lower_to_no_scissor(struct setup *s);
int32 lower_to_no_hold(struct setup *s, int32 leaves_range);

int32 lower_w_is_constant(const struct setup *s);

/* The affine kind for the material's gradients, in a form. */
enum span_kind lower_affine(const struct material *material, enum form form);

#endif
