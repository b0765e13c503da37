#include "drawing/generated.h"

#include "drawing/lower.h"
#include "polygon/kind.h"

enum {
    LAST = MAP_PAGE_SIDE - 1,
    STEEP_32 = 32 * 65536          /* texels a pixel: 8 pixels leave the row */
};

/* Allows a texel more on both sides, because a polygon that shows a whole map has 0 and 256 at its
   vertices. Generated code needs one pair of steps for the polygon; GRADIENTS_SCANLINE has none. */
int32 generated_may_draw(const struct setup *s)
{
    const uint32 texel = 65536, row = MAP_PAGE_SIDE * texel;
    fix16 low, range;

    if (s->material->gradients == GRADIENTS_SCANLINE)
        return 0;
    range = vertex_range(&s->vertices->s, s->count, &low);
    return (((uint32)low + texel) & (row - 1)) + (uint32)range <= row + 2 * texel;
}

/* Returns the texels that the code adds to u from a line's first pixel on; no overflow below
   STEEP_32. */
static int32 offset(fix16 dudx, int32 steps)
{
    return (GENERATED_BIAS + steps * dudx) >> 16;
}

/* Returns 1 if u of every line stays in its row of the map. The code adds u's texels to an address,
   so a u that leaves its row would read another one. u only rises or only falls along a line, so
   testing the last pixel is exact for any start and step. A line needs no product if even a line as
   wide as the box would stay in the row from its start. */
static int32 stays_in_row(const struct setup *s)
{
    const struct scanline *line = s->edges.lines;
    const fix16 dudx = s->span.dudx;
    int32 far, least, most;

    if (dudx >= STEEP_32 || dudx <= -STEEP_32)
        return 0;
    far = offset(dudx, s->box.right - s->box.left - 1);
    least = far < 0 ? -far : 0;
    most = far < 0 ? LAST : LAST - far;
    for (int32 i = s->span.count; i > 0; i--, line++) {
        const int32 u = line->start1 & LAST;

        if (u < least || u > most) {
            const int32 steps = line->last - line->left;

            if (steps >= 0 && (uint32)(u + offset(dudx, steps)) > LAST)
                return 0;
        }
    }
    return 1;
}

/* Converts starts from the plain to the addx form. */
static void pack(struct scanline *line, int32 count)
{
    for (; count > 0; count--, line++) {
        const uint32 u = line->start1 & LAST, v = line->start2;

        line->start1 = (uint16)(v >> 8);
        line->start2 = v << 24 | u;
    }
}

void generated_span(struct setup *s)
{
    const struct material *m = s->material;

    if (stays_in_row(s))
        return;
    s->kind = lower_affine(m, s->form);
    if (kind_lines[s->kind] == LINES_ADDX)
        pack(s->edges.lines, s->span.count);
    if (m->gradients == GRADIENTS_PLANE && m->start == START_SUBTEXEL) {
        s->texturing.v = texturing_middle(&s->texturing, &s->box);      /* all starts are made */
        texturing_wrap(&s->texturing, &s->box, CHAIN_WHOLE);    /* u has all its bits already */
    } else
        s->texturing.wraps = 1;
    lower_by_steps(s);
}
