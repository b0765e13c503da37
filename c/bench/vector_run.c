#include "bench/vector_run.h"

#include "bench/vector_answers.h"
#include "bench/vector_engines.h"
#include "bench/vector_file.h"
#include "system/text.h"

int32 vectors_run(uint32 code, const int32 *values, uint32 count)
{
    static int32 tx_open, tmu_open;
    const int32 tmu = code >= VECTOR_TMU_RESET;
    int32 *open = tmu ? &tmu_open : &tx_open;

    if (!*open)
        *open = tmu ? vector_tmu_open() : vector_tx_open();
    if (!*open)
        return text_refuse("vectors", "not enough memory");
    if (tmu)
        vector_tmu_run(code, values, count);
    else
        vector_tx_run(code, values, count);
    return 1;
}
