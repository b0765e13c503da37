/* What lines of Glide's texture units need of the renderer's scratch room. */
#ifndef GLIDE_SCRATCH_H
#define GLIDE_SCRATCH_H

#include "compiler.h"
#include "limits.h"

/* A texel is its bytes' entries, exclusive-ored: no bit of its colour comes from both. */
struct glide_bytes {
    uint32 low[256], high[256];
};

struct glide_line_scratch {
    /* Between the passes of a line. */
    uint32 coordinates[FRAME_SIDE_MAX];
    uint32 texels[FRAME_SIDE_MAX], other[FRAME_SIDE_MAX], colours[FRAME_SIDE_MAX];
    /* Where pixels' LODs are needed. */
    uint16 lods[FRAME_SIDE_MAX];
    uint8 details[FRAME_SIDE_MAX];
    uint32 quarters[4][FRAME_SIDE_MAX / 4];     /* of a line: each fourth pixel */
    /* While a level is decoded, in the middle of a line. */
    struct glide_bytes bytes;
    /* The pixels of a line that is only counted. */
    uint32 unseen[FRAME_SIDE_MAX];
};

#endif
