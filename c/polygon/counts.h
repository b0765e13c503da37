/* What was executed for a polygon, where it is counted. */
#ifndef COUNTS_H
#define COUNTS_H

#include "polygon/polygon.h"

/* Whether a rule of lowering is followed: it is not switched off, and its condition holds. s: the
   struct setup. */
#define APPLIES(rule, condition) (!(s->off & (uint32)1 << RULE_##rule) && (condition) \
                                  && (!s->counts || count_rule(s->counts, RULE_##rule)))

/* A rule applied: returns 1. Apart from the rules, so that those who do not count keep no
   registers for it. */
int32 count_rule(struct draw_counts *counts, enum rule rule);

#endif
