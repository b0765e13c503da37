#include "polygon/counts.h"

int32 count_rule(struct draw_counts *counts, enum rule rule)
{
    counts->rules[rule]++;
    return 1;
}
