/* Pixels of a line whose s and t are divided at the ends of pieces. */
#include "tmu/plan.h"

int32 tmu_piece_bits(const struct tmu_chain *chain, uint32 unit)
{
    const struct tmu_modes *modes = &chain->units[unit]->modes;

    for (uint32 n = 0; n < chain->count; n++)
        if (chain->units[n]->modes.dither)
            return 0;
    if (!modes->perspective || modes->table_quotients || !modes->subdivision)
        return 0;
    return modes->subdivision == 8 ? 3 : 4;
}

void tmu_pieces_open(struct tmu_pieces *pieces, const struct tmu_chain *chain,
                     const struct tmu_iterations *at, int32 count)
{
    pieces->chain = chain;
    pieces->at = at;
    pieces->count = count;
    pieces->done = 0;
    for (uint32 n = 0; n < chain->count; n++)
        pieces->of[n].bits = at->divided[chain->own >> n & 1 ? n : 0]
            ? tmu_piece_bits(chain, n) : 0;
}

/* The change of a value from pixel to pixel that takes it from one number to another, rounded
   down. */
static int32 step_between(int32 from, int32 to, int32 pixels)
{
    const int32 way = (int32)((uint32)to - (uint32)from), step = pixels ? way / pixels : 0;

    return step * pixels > way ? step - 1 : step;
}

static int32 moved(int32 from, uint32 step, int32 pixels)
{
    return (int32)((uint32)from + step * (uint32)pixels);
}

/* The piece that begins at a point. */
static void begin(struct tmu_pieces *pieces, uint32 unit, const struct tmu_point *point,
                  const struct plane *by)
{
    const struct tmu *tmu = pieces->chain->units[unit];
    struct tmu_piece *piece = &pieces->of[unit];
    const int32 left = pieces->count - 1 - pieces->done, whole = 1 << piece->bits;
    const int32 pixels = left < whole ? left : whole;
    struct tmu_point next;
    int32 s, t;

    next.s = moved(point->s, by[TMU_S].dx, pixels);
    next.t = moved(point->t, by[TMU_T].dx, pixels);
    next.w = moved(point->w, by[TMU_W].dx, pixels);
    tmu_project(tmu, point, &piece->s, &piece->t);
    tmu_project(tmu, &next, &s, &t);
    piece->ds = step_between(piece->s, s, pixels);
    piece->dt = step_between(piece->t, t, pixels);
}

uint32 tmu_pieces_pixel(struct tmu_pieces *pieces)
{
    const struct tmu_chain *chain = pieces->chain;
    uint32 colour = 0;

    for (uint32 n = chain->count; n--;) {
        const uint32 points = chain->own >> n & 1 ? n : 0;
        const struct tmu_point *point = &pieces->at->points[points];
        struct tmu_piece *piece = &pieces->of[n];

        if (!piece->bits) {
            colour = tmu_pixel(chain->units[n], point, colour);
            continue;
        }
        if (!(pieces->done & ((1 << piece->bits) - 1)))
            begin(pieces, n, point, &pieces->at->planes.of[points ? TMU_OWN : TMU_S]);
        colour = tmu_pixel_at(chain->units[n], point, piece->s, piece->t, colour);
        piece->s = moved(piece->s, (uint32)piece->ds, 1);
        piece->t = moved(piece->t, (uint32)piece->dt, 1);
    }
    pieces->done++;
    return colour;
}
