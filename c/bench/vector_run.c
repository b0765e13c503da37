#include "bench/vector_run.h"

#include "bench/vector_answers.h"
#include "bench/vector_engines.h"
#include "bench/vector_file.h"
#include "system/outcome.h"
#include "system/system.h"

int32 vectors_open(void)
{
    uint8 *memory;

    if (!mem_alloc(&memory, VECTOR_DRAM_BYTES, MEMORY_ANY))
        return outcome_lack_memory("vectors", "the engines");
    vector_n64_open(memory);
    vector_glide_open(memory);
    return 1;
}

void vectors_run(uint32 code, const int32 *values, uint32 count)
{
    if (code >= VECTOR_GLIDE_RESET)
        vector_glide_run(code, values, count);
    else
        vector_n64_run(code, values, count);
}
