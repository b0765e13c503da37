#include "n64/n64.h"

const char *n64_result_text(enum n64_result result)
{
    static const char *const texts[] = {
#define RESULT(name, text) text,
        N64_RESULT_LIST(RESULT)
#undef RESULT
    };

    return (uint32)result < N64_RESULTS ? texts[result] : "unknown result";
}
