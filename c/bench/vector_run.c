#include "bench/vector_run.h"

#include "bench/vector_answers.h"
#include "bench/vector_engines.h"
#include "bench/vector_file.h"
#include "system/outcome.h"
#include "system/system.h"

int32 vectors_run(uint32 code, const int32 *values, uint32 count)
{
    static uint8 *memory;
    static int32 tx_open, tmu_open;

    if (!memory && !mem_alloc(&memory, VECTOR_DRAM_BYTES, MEMORY_ANY))
        return outcome_lack_memory("vectors", "the engines");
    if (code >= VECTOR_TMU_RESET) {
        if (!tmu_open)
            vector_tmu_open(memory);
        tmu_open = 1;
        vector_tmu_run(code, values, count);
    } else {
        if (!tx_open)
            vector_tx_open(memory);
        tx_open = 1;
        vector_tx_run(code, values, count);
    }
    return 1;
}
