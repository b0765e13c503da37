/* A pipe of units, and settings for all its polygons. */
#include "glide/polygons/unit.h"

enum glide_result glide_pipe_init(struct glide_pipe *pipe, struct glide *const *units, uint32 count,
                                  int32 memory, struct glide_tile_store *tiles)
{
    uint8 *bytes = (uint8 *)pipe;

    for (uint32 i = 0; i < sizeof *pipe; i++)
        bytes[i] = 0;
    pipe->memory = memory;
    pipe->prefilter = GLIDE_TILES_BYTES;
    pipe->tiles = tiles;
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
    pipe->page.of = 0;
    pipe->lines.is_kept = 0;
    return GLIDE_DONE;
}
