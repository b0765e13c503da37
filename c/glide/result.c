#include "glide/glide.h"

const char *glide_result_text(enum glide_result result)
{
    static const char *const texts[] = {
#define RESULT(name, text) text,
        GLIDE_RESULT_LIST(RESULT)
#undef RESULT
    };

    return (uint32)result < GLIDE_RESULTS ? texts[result] : "unknown result";
}
