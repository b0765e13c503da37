/* How a rule that lowers a span is written. */
#ifndef DRAWING_RULE_H
#define DRAWING_RULE_H

#include "polygon/counts.h"

/* A rule is a line: its name, the kind of span it lowers, the result and the condition. Later lines
   may lower the result further. */
#define LOWER(rule, from, to, condition) LOWER_TO(rule, from, SPAN_##to, condition)
#define LOWER_TO(rule, from, to, condition) \
    if (kind == SPAN_##from && (condition) && RULE_IS_ON(s, rule)) { \
        RULE_APPLIES(s, rule); \
        kind = to; \
    }

#endif
