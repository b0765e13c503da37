#include "span/scanline.h"

/* The affine span in plain C: a reference for the bench. */
void span_affine_c(const struct span_plan *plan)
{
    const struct scanline *line = plan->lines;
    const uint8 *map = plan->map;
    uint32 dudx = (uint32)plan->dudx, dvdx = (uint32)plan->dvdx;
    uint8 *row = plan->row;
    int32 lines = plan->count;

    do {
        uint8 *pixel = row + line->left;
        int32 count = line->last - line->left + 1;
        uint32 u = (uint32)line->start1 << 16 | line->start0, v = line->start2;

        while (--count >= 0) {
            *pixel++ = map[((v >> 8) & 0xff00) | ((u >> 16) & 0xff)];
            u += dudx;
            v += dvdx;
        }
        line++;
        row += plan->pitch;
    } while (--lines > 0);
}
