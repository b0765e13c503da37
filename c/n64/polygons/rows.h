/* Decodes a tile's texels from TMEM, a whole row at a time. */
#ifndef N64_ROWS_H
#define N64_ROWS_H

#include "n64/polygons/scratch.h"

/* Of formats whose texels are numbers: the colour of each, and what it was made from, so that only
   entries of a TLUT that changed are made again. All 0 before the first use. */
struct n64_colours {
    uint32 of[256], from[256];
};

/* How a tile's rows are decoded: see n64_rows_find. */
struct n64_rows {
    struct n64_decode_scratch *scratch;
    const struct n64_colours *colours;
    const struct n64 *n64;
    const struct n64_tile *tile;
    void (*decode)(const struct n64_rows *rows, uint32 at, int32 odd, uint32 *texels,
                   int32 count);        /* null: texel by texel */
};

/* Valid until TMEM, the modes or the tile change, or colours are found for another. */
void n64_rows_find(struct n64_rows *rows, const struct n64 *n64, const struct n64_tile *tile,
                   struct n64_decode_scratch *scratch, struct n64_colours *colours);

/* Decodes texels 0 to count - 1 (1,024 at most) of a row (0 to 256), and perhaps one more: R G B A
   as n64_fetch gives them, from the first copies of TLUT entries. YUV is U + 128, V + 128, Y, Y. */
void n64_rows_decode(const struct n64_rows *rows, int32 row, uint32 *texels, int32 count);

/* Returns any one texel; s and row as n64_fetch has them. */
uint32 n64_rows_texel(const struct n64_rows *rows, int32 s, int32 row);

#endif
