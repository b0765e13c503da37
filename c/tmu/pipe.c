/* A pipe of units, and what is said about all its polygons. */
#include "tmu/unit.h"

enum tmu_result tmu_pipe_init(struct tmu_pipe *pipe, struct tmu *const *units, uint32 count,
                              int32 memory)
{
    static const struct tmu_kept none;

    pipe->own = 0;
    pipe->result = TMU_DONE;
    pipe->memory = memory;
    pipe->prefilter = TMU_TILES_BYTES;
    pipe->adds = 0;
    pipe->settled = 0;
    for (int32 unit = 0; unit < TMU_UNITS; unit++) {
        pipe->bands[unit].count = 0;
        for (int32 level = 0; level <= TMU_LEVEL_LAST; level++)
            pipe->levels[unit][level] = none;
    }
    page_init(&pipe->page.page);
    for (int32 i = 0; i < TMU_PAGE_KEY; i++)
        pipe->page.key[i] = 0;
    return tmu_chain_init(&pipe->chain, units, count);
}

void tmu_pipe_prefilter(struct tmu_pipe *pipe, uint32 bytes)
{
    pipe->prefilter = bytes;
}

enum tmu_result tmu_pipe_adds(struct tmu_pipe *pipe, uint32 adds)
{
    if (adds > 1)
        return TMU_BAD_FLAG;
    pipe->adds = (int32)adds;
    return TMU_DONE;
}
