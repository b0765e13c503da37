/* Lines with perspective by tables of logarithms and powers, written by logarithm_lines and read by
   span_logarithm. u = K + C / q, with K constant over the polygon and C over the line.
   |C| / q = 2^(log2 |C| - log2 q), so that C becomes an offset into the table of powers. */
#ifndef LOGARITHM_H
#define LOGARITHM_H

#include "span/reciprocal.h"

/* A unit of a logarithm is 1/16384 of an octave: 4.23e-5 of the number. */
enum logarithm_constants {
    LOGARITHM_BITS = 14,
    LOGARITHM_OCTAVE = 1 << LOGARITHM_BITS,
    /* Indices are the upper 16 bits of q. They span three octaves, so w may vary by a factor
       of 7. */
    LOGARITHM_LOWEST = 8192,
    LOGARITHM_COUNT = 65537 - LOGARITHM_LOWEST,     /* one more: steps are rounded */
    LOGARITHM_ORIGIN = (LOGARITHM_LOWEST + 65536) / 2,      /* index 0 in the table */
    LOGARITHM_FURTHEST = 8,     /* a line's larger q is at least 2^(31 - this) */
    /* The table of logarithms holds this less each logarithm: from -1.5 to 1.5 octaves. */
    LOGARITHM_MIDDLE = 29 * LOGARITHM_OCTAVE / 2,
    /* Powers are from 1/256 texel, three octaves below LOGARITHM_LEAST's 1/32, to 512 texels. */
    LOGARITHM_LEAST = 3 * LOGARITHM_OCTAVE,
    LOGARITHM_OCTAVES = 17,
    LOGARITHM_POWERS = LOGARITHM_OCTAVES * LOGARITHM_OCTAVE,
    LOGARITHM_PARTS = 256,
    LOGARITHM_OFF = 2048        /* lines are raised by this, their largest error: units */
};

struct logarithm_tables {
    const int16 *logs;          /* at index 0 (ORIGIN): MIDDLE - log2(index + 1/2), rounded */
    const uint16 *powers;       /* 2^(i / OCTAVE), rounded, modulo 2^16 */
    uint32 parts[LOGARITHM_PARTS + 1];  /* log2(1 + i / PARTS), in 1/256 units */
};

/* One line of n + 1 pixels. */
struct logarithm_line {
    uint16 left;                /* x of the first pixel + EDGE_BIAS */
    int16 n;                    /* below 0: nothing to draw */
    uint32 q, dq;               /* first index, and its step a pixel; fraction:integer */
    uint16 u, v;                /* K, 8.8 */
    int32 power_u, power_v;     /* log2 |C|: bytes from powers to the power for a logarithm of 0 */
    uint16 way;                 /* bit 0: C of u is negative, bit 1: C of v is */
    uint16 spare;
};

/* Everything a span by logarithms needs: it draws the whole table. */
struct logarithm_span {
    const struct logarithm_line *lines;
    int32 count;                /* lines, 1 or more */
    uint8 *row;                 /* pixel -EDGE_BIAS of the first line */
    int32 pitch;                /* bytes from line to line */
    const uint8 *map;           /* MAP_PAGE */
    const int16 *logs;          /* as in the tables */
    const uint16 *powers;
};

/* Fills the tables: LOGARITHM_COUNT logarithms at logs, LOGARITHM_POWERS powers at powers. Takes
   15.9 million cycles in fast RAM. */
void logarithms_make(struct logarithm_tables *tables, int16 *logs, uint16 *powers);

/* src68k: contracts there. */
int32 logarithm_lines(const struct reciprocal_plan *plan, const struct logarithm_tables *tables,
                      struct logarithm_line *to);
void span_logarithm(const struct logarithm_span *span);

#endif
