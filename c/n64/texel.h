/* From a tile's coordinates to a texel's colour: each step as the hardware has it. */
#ifndef N64_TEXEL_H
#define N64_TEXEL_H

#include "n64/n64.h"

/* Colours between the passes: 0 to 255; from YUV texels, colour conversion and combiner
   signed 9 bits, -256 to 255. A YUV texel is U, V, Y, Y with U and V from -128 on. */
struct n64_colour {
    int16 r, g, b, a;
};

/* A column or row: the texel's index, and how far on the neighbour's is. */
struct n64_place {
    int32 index, step;
};

/* A coordinate (s10.5) after an axis' shift. */
static inline int32 n64_shifted(const struct n64_axis *axis, int32 c)
{
    return axis->shift <= 10 ? (int16)c >> axis->shift
                             : (int16)((uint32)c << (16 - axis->shift));
}

/* coordinates.c. c: s10.5. Relative coordinate: 11.5 bits unsigned; steps 1-4 (shift, clamp,
   origin). Where the axis neither clamps nor masks nothing, it is modulo 2^16. */
uint32 n64_relative(const struct n64_axis *axis, int32 c);

/* coordinates.c. Step 5 (mirror, mask) for a relative coordinate's integer part. Columns and
   rows differ in the last one's step. Of a row's index the texels only see the low 8 bits, but
   for copy mode. */
void n64_place_column(const struct n64_axis *axis, uint32 column, struct n64_place *place);
void n64_place_row(const struct n64_axis *axis, uint32 row, struct n64_place *place);

/* texel.c. One texel of a tile. s: column, any; row: 0 to 256. tap: which of the four copies
   of a TLUT entry (0-3: that and its neighbours in s, t, both). */
void n64_fetch(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row, int32 tap,
               struct n64_colour *texel);

/* texel.c. Address of a texel of 4, 8 or 16 bits: a byte's number in TMEM. */
uint32 n64_texel_address(const struct n64_tile *tile, uint32 size, int32 s, int32 row);

/* texel.c. The entry that a texel names while TLUT is on, from the low half of TMEM alone. */
uint32 n64_tlut_index(const struct n64 *n64, const struct n64_tile *tile, int32 s, int32 row);

/* texel.c. A TLUT's entry: 16 bits, as they are. */
uint32 n64_tlut_entry(const struct n64 *n64, uint32 index, int32 tap);

/* filter.c. Samples tile n at s, t (s10.5) as the modes of the cycle (0 or 1) say. previous:
   cycle 0's sample, which cycle 1 may convert. */
void n64_sample(const struct n64 *n64, int32 n, int32 s, int32 t, int32 cycle,
                const struct n64_colour *previous, struct n64_colour *out);

/* convert.c. Signed U, V, Y to R, G, B, A = Y; each signed 9 bits. */
void n64_convert_texel(const struct n64 *n64, const struct n64_colour *yuv, struct n64_colour *out);

/* copy.c. Four texels of copy mode from s, t (s10.5) on: two longs of 16-bit texels, of which
   one-bit alpha is bit 0. */
void n64_copy_texels(const struct n64 *n64, int32 n, int32 s, int32 t, uint32 *texels);

#endif
