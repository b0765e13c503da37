/* Perspective: s / w and t / w through a table of reciprocals. */
#include "n64/bits.h"
#include "n64/pixel.h"

const uint16 n64_inverses[65] = {
    16384, 16132, 15888, 15650, 15420, 15197, 14979, 14769, 14564, 14364, 14170, 13981, 13797,
    13618, 13443, 13273, 13107, 12945, 12788, 12633, 12483, 12336, 12193, 12053, 11916, 11782,
    11651, 11523, 11398, 11275, 11155, 11038, 10923, 10810, 10700, 10592, 10486, 10382, 10280,
    10180, 10082, 9986, 9892, 9800, 9709, 9620, 9533, 9447, 9362, 9279, 9198, 9118, 9039, 8962,
    8886, 8812, 8738, 8666, 8595, 8525, 8456, 8389, 8322, 8257, 8192
};

/* Finds one coordinate, before (raw) and after the clamp to 16 bits. */
static void divide(int32 s, int32 reciprocal, int32 shift, int32 bad, int32 *raw, int32 *clamped,
                   int32 *overflow)
{
    const int32 product = s * reciprocal;
    const int32 value = shift == 14 ? product * 2 : product >> (13 - shift);
    const int32 cut = n64_signed_17(value), over = bad ? 1 : value == cut ? 0 : s < 0 ? -1 : 1;

    *raw = cut;
    *overflow = over;
    *clamped = over > 0 || (!over && cut > 32767) ? 32767 : over < 0 || cut < -32768 ? -32768 : cut;
}

void n64_quotients(int32 s, int32 t, int32 w, struct n64_divided *out)
{
    const int32 bad = (int16)w <= 0;
    int32 shift = 0, low, reciprocal;
    const uint16 *entry;

    w &= 0x7fff;
    while (shift < 14 && !(w << shift & 0x4000))
        shift++;
    low = w << shift & 0x3fff;
    entry = &n64_inverses[low >> 8];
    reciprocal = entry[0] + (((entry[1] - entry[0]) * (low & 255) * 4) >> 10);
    divide((int16)s, reciprocal, shift, bad, &out->raw_s, &out->s, &out->overflow_s);
    divide((int16)t, reciprocal, shift, bad, &out->raw_t, &out->t, &out->overflow_t);
}

void n64_project(const struct n64 *n64, const struct n64_iterators *at, struct n64_divided *out)
{
    if (n64->modes.perspective) {
        n64_quotients(at->s >> 16, at->t >> 16, at->w >> 16, out);
        return;
    }
    out->s = out->raw_s = at->s >> 16;
    out->t = out->raw_t = at->t >> 16;
    out->overflow_s = out->overflow_t = 0;
}
