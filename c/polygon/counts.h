/* What was executed for a polygon, where it is counted. */
#ifndef COUNTS_H
#define COUNTS_H

#include "polygon/polygon.h"

/* A rule applied: returns 1. Apart from the rules, so that those who do not count keep no
   registers for it. */
int32 count_rule(struct draw_counts *counts, enum rule rule);

#endif
