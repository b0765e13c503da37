/* Rules of lowering, and counts of polygons, pixels and rules. */
#ifndef COUNTS_H
#define COUNTS_H

#include "polygon/setup.h"

#define RULE_BIT(rule) ((uint32)1 << RULE_##rule)

/* Non-zero if a rule of lowering is on. */
#define RULE_IS_ON(s, rule) (!((s)->off & RULE_BIT(rule)))

/* Records that a rule applied. */
#define RULE_APPLIES(s, rule) ((s)->applied |= RULE_BIT(rule))

/* Counts the polygon, and the pixels of its lines for a kind of span. */
void count_lines(const struct setup *s, enum span_kind kind);

/* Returns the pixels that were drawn: passes over them count them once more. */
uint32 counts_drawn(const struct draw_counts *counts);

/* Counts the rules that applied if the renderer counts; returns `result`. */
static inline enum polygon_result count_rules(const struct setup *s, enum polygon_result result)
{
    if (s->counts)
        for (int32 rule = 0; rule < RULES; rule++)
            s->counts->rules[rule] += s->applied >> rule & 1;
    return result;
}

/* Counts a polygon that is drawn affine as its planes are too inexact, if counts are kept; returns 0. */
int32 count_unsure(const struct setup *s);

#endif
