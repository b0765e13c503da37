/* Counts of the rules that apply to polygons. */
#ifndef COUNTS_H
#define COUNTS_H

#include "polygon/polygon.h"

/* True if a rule of lowering applies: it is not switched off, and its condition holds. Counts it if
   there are counts. s: the struct setup. */
#define APPLIES(rule, condition) (!(s->off & (uint32)1 << RULE_##rule) && (condition) \
                                  && (!s->counts || count_rule(s->counts, RULE_##rule)))

/* Counts a rule that applied; returns 1. A separate function, so that rules keep no registers for
   it when they are not counted. */
int32 count_rule(struct draw_counts *counts, enum rule rule);

#endif
