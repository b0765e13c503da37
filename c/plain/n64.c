#include "plain/n64.h"

void n64_reciprocals_c(const struct pass_call *call)
{
    n64_divide_table_make(call->out);
}

void n64_levels_c(const struct pass_call *call)
{
    n64_levels_make(call->out, call->constants);
}

void n64_matrix_c(const struct pass_call *call)
{
    n64_matrix_make(call->out, call->in);
}
