/* The argument with which the bench calls a pass in plain C. */
#ifndef PLAIN_CALL_H
#define PLAIN_CALL_H

#include "compiler.h"

struct pass_call {
    const void *in;
    void *out;
    const void *constants;
    int32 count;
};

#endif
