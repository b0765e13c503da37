#include "screen/blits.h"

#include "screen/copper.h"

enum blit_bits {
    MASKED = 0x0de40000,        /* A, B and D are read and written; C's 1 takes A, its 0 takes B */
    DESCENDING = 2,
    SHIFT_A = 28, SHIFT_B = 12,
    TWOS = 0xcccc, ONES = 0xaaaa
};

int32 blits_bytes(const struct screen_layout *layout)
{
    return PLANES / layout->dots * layout->plane_bytes;
}

/* What all blits of a frame have. */
struct extent {
    int32 bytes;                /* of the rows of a plane */
    uint16 rows, words;
};

/* Adds a blit over rows of planes: where the mask is 1, a's bits, else b's, which move right by `shift`; or, with `left`,
   a's move left and b's stay. */
static struct blit *add(struct blit *to, const struct extent *extent, const uint8 *a, const uint8 *b, uint8 *d,
                        uint32 mask, uint32 shift, int32 left)
{
    const int32 first = left ? extent->bytes - 2 : 0;

    to->control = MASKED | (left ? shift << SHIFT_A | DESCENDING : shift << SHIFT_B);
    to->a = a + first;
    to->b = b + first;
    to->d = d + first;
    to->mask = (uint16)mask;
    to->rows = extent->rows;
    to->words = extent->words;
    return to + 1;
}

/* Adds both blits of a pair of half planes x and y, which exchange x's right groups of `shift` bits and y's left
   ones: with x's left ones to the plane `high`, with y's right ones to `low`. */
static struct blit *merge(struct blit *to, const struct extent *extent, const uint8 *x, const uint8 *y,
                          uint8 *high, uint8 *low, uint32 mask, uint32 shift)
{
    to = add(to, extent, x, y, high, mask, shift, 0);
    return add(to, extent, x, y, low, mask, shift, 1);
}

/* Pixels of one dot: merges by 1 bit to `merged`, if that is not 0, and by 2 bits to planes. bytes: of a plane. */
static struct blit *merge_plain(struct blit *to, const struct extent *extent, int32 bytes, const uint8 *from,
                                uint8 *merged, uint8 *planes)
{
    if (merged) {
        for (int32 i = 0; i < PLANES; i += 2)
            to = merge(to, extent, from + (i + 1) * bytes, from + i * bytes, merged + (i + 1) * bytes,
                       merged + i * bytes, ONES, 1);
        from = merged;
    }
    for (int32 i = 0; i < 4; i++) {
        const int32 at = ((i & 2) * 2 + (i & 1)) * bytes;

        to = merge(to, extent, from + at, from + at + 2 * bytes, planes + at + 2 * bytes, planes + at, TWOS, 2);
    }
    return to;
}

/* Pixels of two dots: merges by 2 bits to `merged`, if that is not 0, and doubles to planes. */
static struct blit *merge_doubled(struct blit *to, const struct extent *extent, int32 bytes, const uint8 *from,
                                  uint8 *merged, uint8 *planes)
{
    if (merged) {
        for (int32 i = 0; i < PLANES / 2; i += 2)
            to = merge(to, extent, from + i * bytes, from + (i + 1) * bytes, merged + (i + 1) * bytes,
                       merged + i * bytes, TWOS, 2);
        from = merged;
    }
    for (int32 i = 0; i < PLANES / 2; i++, from += bytes, planes += 2 * bytes)
        to = merge(to, extent, from, from, planes + bytes, planes, ONES, 1);
    return to;
}

int32 blits_make(struct blit *blits, const struct screen_layout *layout, uint8 *from, uint8 *merged, uint8 *planes,
                 int32 top, int32 rows)
{
    const int32 first = top * layout->row_bytes;
    struct extent extent;

    extent.bytes = rows * layout->row_bytes;
    extent.rows = (uint16)rows;
    extent.words = (uint16)(layout->row_bytes >> 1);
    return (int32)((layout->dots > 1 ? merge_doubled : merge_plain)(
        blits, &extent, layout->plane_bytes, from + first, merged ? merged + first : 0, planes + first) - blits);
}
