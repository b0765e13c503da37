/* What a texture engine's polygons need of the renderer's scratch room. */
#ifndef N64_SCRATCH_H
#define N64_SCRATCH_H

#include "n64/passes.h"
#include "n64/texel.h"

enum n64_scratch_constants { N64_LINE_PIXELS = 256 };  /* that the passes draw at a time */

/* A line's samples of one tile: luma, the last byte of each, and chroma, the first two. */
struct n64_yuv_line {
    uint32 luma[N64_LINE_PIXELS], chroma[N64_LINE_PIXELS];
};

/* Between the passes of a line. */
struct n64_line_scratch {
    uint32 coordinates[N64_LINE_PIXELS], relative[N64_LINE_PIXELS];
    struct n64_blending blendings[N64_LINE_PIXELS + 1]; /* the last: N64_NO_TILES */
    uint32 texels0[N64_LINE_PIXELS], texels1[N64_LINE_PIXELS];
    uint32 shades[N64_LINE_PIXELS], colours[N64_LINE_PIXELS];
    struct n64_yuv_line yuv[2];
    struct n64_wide wide[3][N64_LINE_PIXELS];   /* texel 0, texel 1, shade */
    struct n64_wide results[2][N64_LINE_PIXELS];  /* of both cycles */
    uint32 pixels[N64_LINE_PIXELS];     /* of lines that are drawn together */
};

/* One column of a decoded tile: its texel, the one beside it in quads, and the decoded column that
   shows that, or -1. */
struct n64_column {
    int16 index, next, next_at;
};

/* While a tile is decoded. */
struct n64_decode_scratch {
    struct n64_column columns[2048];    /* as many as a mirrored mask of 10 bits has */
    uint32 line[N64_COLUMNS_MAX + 1];   /* both at a time: some formats decode one more */
    uint32 below[2048];
    const uint32 *shown[N64_ROWS_MAX];
    uint32 words[512], words_high[512]; /* rows of TMEM, in order */
};

/* While tables of the combiner are made. */
struct n64_table_scratch {
    struct n64_wide values[512], results[512];
};

union n64_scratch {
    struct n64_line_scratch line;
    struct n64_decode_scratch decode;
    struct n64_table_scratch tables;
};

#endif
