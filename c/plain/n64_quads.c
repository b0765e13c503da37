#include "plain/n64.h"

#define FIELD 0x00ff00ffu
#define SCALE 8u        /* a channel's integer is the upper byte of its word */

/* Two channels' differences; the words are added as signed numbers. */
static uint32 difference(uint32 texel, uint32 corner)
{
    return SCALE * (texel - corner);
}

static uint32 corner_of(uint32 pair)
{
    return SCALE * (32 * pair + 0x00100010u);
}

static void triangle_make(struct n64_triangle *triangle, uint32 corner, uint32 in_s, uint32 in_t)
{
    const uint32 rb = corner >> 8 & FIELD, ga = corner & FIELD;

    triangle->rb_s = difference(in_s >> 8 & FIELD, rb);
    triangle->rb_t = difference(in_t >> 8 & FIELD, rb);
    triangle->rb = corner_of(rb);
    triangle->ga_s = difference(in_s & FIELD, ga);
    triangle->ga_t = difference(in_t & FIELD, ga);
    triangle->ga = corner_of(ga);
}

static uint32 mean(uint32 a, uint32 b, uint32 c, uint32 d)
{
    return SCALE * (8 * ((a & FIELD) + (b & FIELD) + (c & FIELD) + (d & FIELD)) + 0x00100010u);
}

void n64_quads_c(const struct pass_call *call)
{
    const struct n64_quad_row *row = call->constants;
    const uint32 *above = call->in, *below = row->below;
    struct n64_quad *quad = call->out;
    int32 count = call->count;

    do {
        const uint32 c00 = *above, c01 = *below;

        above += row->step;
        below += row->step;
        triangle_make(&quad->lower, c00, *above, c01);
        triangle_make(&quad->upper, *below, c01, *above);
        quad->mean_rb = mean(c00 >> 8, *above >> 8, c01 >> 8, *below >> 8);
        quad->mean_ga = mean(c00, *above, c01, *below);
        quad += row->step;
    } while (--count > 0);
}
