/* Rules of lowering, and what is counted of a polygon. */
#ifndef COUNTS_H
#define COUNTS_H

#include "polygon/setup.h"

#define RULE_BIT(rule) ((uint32)1 << RULE_##rule)

/* Whether a rule of lowering is on. */
#define RULE_IS_ON(s, rule) (!((s)->off & RULE_BIT(rule)))

/* Notes that it applied. */
#define RULE_APPLIES(s, rule) ((s)->applied |= RULE_BIT(rule))

/* Counts the pixels of the polygon's lines for a kind of span, and the polygon. */
void count_lines(const struct setup *s, enum span_kind kind);

/* Counts the rules that applied, where the renderer counts; returns the result. */
static inline enum polygon_result count_rules(const struct setup *s, enum polygon_result result)
{
    if (s->counts)
        for (int32 rule = 0; rule < RULES; rule++)
            s->counts->rules[rule] += s->applied >> rule & 1;
    return result;
}

#endif
