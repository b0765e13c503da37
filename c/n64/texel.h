/* From a tile's coordinates to a texel's colour, step by step as in the hardware. */
#ifndef N64_TEXEL_H
#define N64_TEXEL_H

#include "n64/n64.h"

/* Colours between the passes: 0 to 255; from YUV texels, colour conversion and combiner
   signed 9 bits, -256 to 255. A YUV texel is U, V, Y, Y; U and V are -128 to 127. */
struct n64_colour {
    int16 r, g, b, a;
};

/* A column or row: the texel's index, and the distance to its neighbour's index. */
struct n64_place {
    int32 index, step;
};

/* A coordinate (s10.5) after an axis' shift. */
static inline int32 n64_shifted(const struct n64_axis *axis, int32 c)
{
    return axis->shift <= 10 ? (int16)c >> axis->shift
                             : (int16)((uint32)c << (16 - axis->shift));
}

/* coordinates.c. c: s10.5. Returns the relative coordinate, 11.5 bits unsigned: steps 1-4 (shift,
   clamp, origin). If the axis has a mask and does not clamp, it is modulo 2^16. */
uint32 n64_relative(const struct n64_axis *axis, int32 c);

/* coordinates.c. Step 5 (mirror, mask) for a relative coordinate's integer part. Columns and
   rows differ in the last one's step: `wrapped` is N64_COLUMN or N64_ROW. Except in copy mode, only
   the low 8 bits of a row's index address texels. */
enum { N64_COLUMN = 0x3ff, N64_ROW = 0xff };

void n64_place(const struct n64_axis *axis, uint32 index, uint32 wrapped, struct n64_place *place);

/* texel.c. Fetches one texel of a tile. s: column, any; row: 0 to 256. tap: which of the four
   copies of a TLUT entry to read (0: for the texel itself; 1, 2, 3: for its neighbour in s, in t,
   in both). */
void n64_fetch(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row, int32 tap,
               struct n64_colour *texel);

/* texel.c. Returns the address of a texel of 4, 8 or 16 bits: a byte's number in TMEM. */
uint32 n64_texel_address(const struct n64_tile *tile, uint32 size, int32 s, int32 row);

/* texel.c. Returns the TLUT entry that a texel names. The texel is read from TMEM's low half. */
uint32 n64_tlut_index(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row);

/* texel.c. Returns a TLUT entry's 16 bits. */
uint32 n64_tlut_entry(const struct n64 *n64, uint32 index, int32 tap);

/* filter.c. Samples tile n at s, t (s10.5) by the modes of the cycle (0 or 1). previous: cycle
   0's sample, which cycle 1 may convert. */
void n64_sample(const struct n64 *n64, int32 n, int32 s, int32 t, int32 cycle,
                const struct n64_colour *previous, struct n64_colour *out);

/* convert.c. Converts signed U, V, Y to R, G, B, A = Y; each signed 9 bits. */
void n64_convert_texel(const struct n64 *n64, const struct n64_colour *yuv, struct n64_colour *out);

/* copy.c. Reads four texels in copy mode from s, t (s10.5) on: two longs of 16-bit texels, whose
   one-bit alpha is bit 0. */
void n64_copy_texels(const struct n64 *n64, int32 n, int32 s, int32 t, uint32 *texels);

#endif
