/* Rows of a tile's texels out of TMEM, each in one go. */
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
                   int32 count);        /* 0: texel by texel */
};

/* Valid until TMEM, the modes or the tile change, or colours are found for another. */
void n64_rows_find(struct n64_rows *rows, const struct n64 *n64, const struct n64_tile *tile,
                   struct n64_decode_scratch *scratch, struct n64_colours *colours);

/* Texels 0 to count - 1 (1,024 at most) of a row (0 to 256), and perhaps one more, R G B A: what
   n64_fetch makes of them, of TLUT entries their first copies. YUV has U + 128, V + 128, Y, Y. */
void n64_rows_decode(const struct n64_rows *rows, int32 row, uint32 *texels, int32 count);

/* Any texel, as n64_fetch takes them. */
uint32 n64_rows_texel(const struct n64_rows *rows, int32 s, int32 row);

#endif
