/* The filters: point, three points, average; YUV's chroma has its own fraction. */
#include "n64/bits.h"
#include "n64/texel.h"

/* Filters one channel; fs, ft: 0 to 31. */
static int32 three_points(int32 c00, int32 c10, int32 c01, int32 c11, int32 fs, int32 ft)
{
    if (fs + ft < 32)
        return c00 + ((fs * (c10 - c00) + ft * (c01 - c00) + 16) >> 5);
    return c11 + (((32 - fs) * (c01 - c11) + (32 - ft) * (c10 - c11) + 16) >> 5);
}

/* Cycle 1 with both filtering and convert_one on: the texels' differences are weighted by the
   first two channels of cycle 0's sample and added to its third. In the middle a quarter of the
   fourth texel's difference is added too. */
static int32 weigh(int32 c00, int32 c10, int32 c01, int32 c11, int32 upper, int32 mid,
                   const struct n64_colour *by)
{
    const int32 from = upper ? c11 : c00;
    const int32 ds = upper ? c01 - from : c10 - from, dt = upper ? c10 - from : c01 - from;

    return by->b + ((by->r * ds + by->g * dt + (mid ? 64 * (c00 - from) : 0) + 0x80) >> 8);
}

/* A filter's fractions, for luma or colour and for chroma, and its modes. */
struct fractions {
    int32 s, chroma_s, t;
    int32 mid;                  /* the mode */
    const struct n64_colour *by; /* for weigh, or 0 */
};

static int16 filter(int32 c00, int32 c10, int32 c01, int32 c11, int32 fs,
                    const struct fractions *at)
{
    const int32 mid = at->mid && fs == 16 && at->t == 16;

    if (at->by)
        return (int16)n64_signed_9(weigh(c00, c10, c01, c11, fs + at->t >= 32, mid, at->by));
    if (mid)
        return (int16)n64_signed_9((c00 + c10 + c01 + c11 + 2) >> 2);
    return (int16)n64_signed_9(three_points(c00, c10, c01, c11, fs, at->t));
}

/* The four texels of a quad. In YUV, chroma's second column may differ from luma's. */
struct taps {
    struct n64_colour c00, c10, c01, c11;
};

static void filter_taps(const struct taps *taps, const struct fractions *at,
                        struct n64_colour *out)
{
    out->r = filter(taps->c00.r, taps->c10.r, taps->c01.r, taps->c11.r, at->chroma_s, at);
    out->g = filter(taps->c00.g, taps->c10.g, taps->c01.g, taps->c11.g, at->chroma_s, at);
    out->b = filter(taps->c00.b, taps->c10.b, taps->c01.b, taps->c11.b, at->s, at);
    out->a = filter(taps->c00.a, taps->c10.a, taps->c01.a, taps->c11.a, at->s, at);
}

/* Finds the corner that a filter would start from; used for quads with the filter off. */
static void nearest_corner(const struct taps *taps, const struct fractions *at,
                           struct n64_colour *out)
{
    const struct n64_colour *chroma = at->chroma_s + at->t >= 32 ? &taps->c11 : &taps->c00;
    const struct n64_colour *luma = at->s + at->t >= 32 ? &taps->c11 : &taps->c00;

    out->r = chroma->r;
    out->g = chroma->g;
    out->b = luma->b;
    out->a = luma->a;
}

static void fetch_taps(const struct n64 *n64, const struct n64_tile *tile,
                       const struct n64_place *column, const struct n64_place *row,
                       struct taps *taps)
{
    const int32 s0 = column->index, s1 = s0 + column->step;
    const int32 t0 = row->index & 255, t1 = t0 + row->step;

    n64_fetch(n64, tile, s0, t0, 0, &taps->c00);
    n64_fetch(n64, tile, s1, t0, 1, &taps->c10);
    n64_fetch(n64, tile, s0, t1, 2, &taps->c01);
    n64_fetch(n64, tile, s1, t1, 3, &taps->c11);
    if (tile->format == N64_YUV) {      /* chroma's neighbour is the next pair's */
        struct n64_colour next;

        n64_fetch(n64, tile, s1 + column->step, t0, 1, &next);
        taps->c10.r = next.r;
        taps->c10.g = next.g;
        n64_fetch(n64, tile, s1 + column->step, t1, 3, &next);
        taps->c11.r = next.r;
        taps->c11.g = next.g;
    }
}

void n64_sample(const struct n64 *n64, int32 n, int32 s, int32 t, int32 cycle,
                const struct n64_colour *previous, struct n64_colour *out)
{
    const struct n64_tile *tile = &n64->tiles[n & 7];
    const int32 filters = cycle ? n64->modes.filter1 : n64->modes.filter0;
    const uint32 relative_s = n64_relative(&tile->s, s), relative_t = n64_relative(&tile->t, t);
    const int32 again = cycle && n64->modes.convert_one;
    struct n64_place column, row;

    n64_place(&tile->s, relative_s >> 5, N64_COLUMN, &column);
    n64_place(&tile->t, relative_t >> 5, N64_ROW, &row);
    if (!n64->modes.quad) {
        if (filters && again)   /* four equal texels */
            out->r = out->g = out->b = out->a = previous->b;
        else
            n64_fetch(n64, tile, column.index, row.index & 255, 0, out);
    } else {
        struct fractions at;
        struct taps taps;

        at.s = at.chroma_s = (int32)(relative_s & 31);
        at.t = (int32)(relative_t & 31);
        if (tile->format == N64_YUV)
            at.chroma_s = at.s >> 1 | (column.index & 1) << 4;
        at.by = again ? previous : 0;
        at.mid = n64->modes.mid;
        fetch_taps(n64, tile, &column, &row, &taps);
        if (filters)
            filter_taps(&taps, &at, out);
        else
            nearest_corner(&taps, &at, out);
    }
    if (!filters)
        n64_convert_texel(n64, again ? previous : out, out);
}
