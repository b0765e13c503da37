#include "bench/vector_run.h"

#include "bench/vector_answers.h"
#include "bench/vector_engines.h"
#include "bench/vector_file.h"
#include "system/outcome.h"
#include "system/system.h"

int32 vectors_run(uint32 code, const int32 *values, uint32 count)
{
    static uint8 *memory;
    static int32 n64_open, glide_open;

    if (!memory && !mem_alloc(&memory, VECTOR_DRAM_BYTES, MEMORY_ANY))
        return outcome_lack_memory("vectors", "the engines");
    if (code >= VECTOR_GLIDE_RESET) {
        if (!glide_open)
            vector_glide_open(memory);
        glide_open = 1;
        vector_glide_run(code, values, count);
    } else {
        if (!n64_open)
            vector_n64_open(memory);
        n64_open = 1;
        vector_n64_run(code, values, count);
    }
    return 1;
}
