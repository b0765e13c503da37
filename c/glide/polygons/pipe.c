/* A pipe of units, and settings for all its polygons. */
#include "glide/polygons/unit.h"

enum glide_result glide_pipe_init(struct glide_pipe *pipe, struct glide *const *units, uint32 count,
                                  int32 memory, struct glide_tile_store *tiles)
{
    static const struct glide_kept none;

    pipe->result = GLIDE_DONE;
    pipe->memory = memory;
    pipe->prefilter = GLIDE_TILES_BYTES;
    pipe->adds = 0;
    pipe->tiles = tiles;
    for (int32 unit = 0; unit < GLIDE_UNITS; unit++) {
        pipe->bands[unit].count = 0;
        for (int32 level = 0; level <= GLIDE_LEVEL_LAST; level++)
            pipe->levels[unit][level] = none;
    }
    page_init(&pipe->page);
    return glide_chain_init(&pipe->chain, units, count);
}

void glide_pipe_prefilter(struct glide_pipe *pipe, uint32 bytes)
{
    pipe->prefilter = bytes;
}

enum glide_result glide_pipe_adds(struct glide_pipe *pipe, uint32 adds)
{
    if (adds > 1)
        return GLIDE_BAD_FLAG;
    pipe->adds = (int32)adds;
    return GLIDE_DONE;
}
