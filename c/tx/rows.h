/* Rows of a tile's texels out of TMEM, each in one go. */
#ifndef TX_ROWS_H
#define TX_ROWS_H

#include "tx/texel.h"

/* How a tile's rows are decoded: see tx_rows_find. */
struct tx_rows {
    const struct tx *tx;
    const struct tx_tile *tile;
    void (*decode)(const struct tx_rows *rows, uint32 at, int32 odd, uint32 *texels,
                   int32 count);        /* 0: texel by texel */
};

/* Valid until TMEM, the modes or the tile change, or this is called again. */
void tx_rows_find(struct tx_rows *rows, const struct tx *tx, const struct tx_tile *tile);

/* Texels 0 to count - 1 (1,024 at most) of a row (0 to 256), and perhaps one more, R G B A: what
   tx_fetch makes of them, of TLUT entries their first copies. YUV has U + 128, V + 128, Y, Y. */
void tx_rows_decode(const struct tx_rows *rows, int32 row, uint32 *texels, int32 count);

/* Any texel, as tx_fetch takes them. */
uint32 tx_rows_texel(const struct tx_rows *rows, int32 s, int32 row);

#endif
