/* Lowering: a polygon is drawn by the cheapest spans that give the same picture. lower.c has the
   rules, RULE_LIST of polygon/span_list.h their meaning. */
#ifndef LOWER_H
#define LOWER_H

#include "polygon/setup.h"

/* Returns non-zero if nothing is drawn; called before the set-up. */
int32 lower_to_nothing(struct setup *s);

/* Sets s->kind to the material's kind of span. Returns non-zero if the vertices may allow a cheaper
   one. */
int32 lower_asked(struct setup *s);

/* Lowers s->kind by the vertices. */
void lower_by_vertices(struct setup *s);

/* SPAN_PERSPECTIVE: sets s->setting to the material's perspective and s->straight to 0, then lowers
   them by the planes. */
void lower_by_planes(struct setup *s);

/* Lowers s->kind by the box and the steps of texturing; not with GRADIENTS_SCANLINE. */
void lower_by_steps(struct setup *s);

/* Return non-zero if lines need not be cut to the frame's columns, and if they need not be moved to
   keep u and v in range. */
int32 lower_to_no_scissor(struct setup *s);
int32 lower_to_no_clamp(struct setup *s, int32 leaves_range);

int32 lower_w_is_constant(const struct setup *s);

/* Returns the affine kind for the material's gradients and a form. */
enum span_kind lower_affine(const struct material *material, enum form form);

#endif
