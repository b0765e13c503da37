/* Lowering: a polygon is drawn by the least that gives the same picture. */
#ifndef LOWER_H
#define LOWER_H

#include "polygon/setup.h"

/* What rules may lead from and to besides kinds of span. */
enum work {
    WORK_POLYGON = SPAN_PERSPECTIVE + 1,        /* all of it */
    WORK_SCISSOR,                       /* lines cut to the frame's columns */
    WORK_HOLD,                          /* lines moved until u and v stay in their range */
    WORK_NONE
};

/* Whether a rule that leaves work out applies; counts it. */
int32 lower_leaves_out(struct setup *s, enum rule rule);

/* Makes s->kind what the material asks for, lowered by what the vertices show. */
void lower_by_vertices(struct setup *s);

/* Lowers s->kind by what box and texturing show. */
void lower_by_steps(struct setup *s);

/* SPAN_PERSPECTIVE: lowers s->setting by what its planes show. */
void lower_by_planes(struct setup *s);

int32 lower_w_is_constant(struct setup *s);

/* The affine kind for the material's gradients, in a form. */
enum span_kind lower_affine(const struct material *material, enum form form);

#endif
