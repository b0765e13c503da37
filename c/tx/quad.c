#include "tx/decode.h"

#define FIELDS 0x00ff00ffu
#define HALVES 0x00100010u      /* 16 in both fields: rounds */

static void make(uint32 *corner, uint32 *by_s, uint32 *by_t, uint32 from, uint32 beside,
                 uint32 below)
{
    *corner = 32 * from + HALVES;
    *by_s = beside - from;
    *by_t = below - from;
}

void tx_quad_make(struct tx_quad *quad, uint32 c00, uint32 c10, uint32 c01, uint32 c11)
{
    const uint32 rb00 = c00 >> 8 & FIELDS, rb10 = c10 >> 8 & FIELDS, rb01 = c01 >> 8 & FIELDS,
        rb11 = c11 >> 8 & FIELDS;
    const uint32 ga00 = c00 & FIELDS, ga10 = c10 & FIELDS, ga01 = c01 & FIELDS,
        ga11 = c11 & FIELDS;
    struct tx_triangle *lower = &quad->lower, *upper = &quad->upper;

    make(&lower->rb, &lower->rb_s, &lower->rb_t, rb00, rb10, rb01);
    make(&lower->ga, &lower->ga_s, &lower->ga_t, ga00, ga10, ga01);
    make(&upper->rb, &upper->rb_s, &upper->rb_t, rb11, rb01, rb10);
    make(&upper->ga, &upper->ga_s, &upper->ga_t, ga11, ga01, ga10);
    quad->mean_rb = 8 * (rb00 + rb10 + rb01 + rb11) + HALVES;
    quad->mean_ga = 8 * (ga00 + ga10 + ga01 + ga11) + HALVES;
}
