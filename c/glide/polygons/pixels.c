/* Draws a line pixel by pixel, in all modes. */
#include "glide/polygons/plan.h"

/* A unit's piece of the line: s and t of the pixel (14.18) and their steps. */
struct piece {
    int32 bits;                 /* 2^bits pixels; 0: no pieces */
    int32 s, t, ds, dt;
};

struct line {
    const struct glide_chain *chain;
    const struct glide_iterations *at;  /* points: the pixel's */
    int32 count, done;
    struct piece pieces[GLIDE_UNITS];
};

int32 glide_piece_bits(const struct glide_chain *chain, uint32 unit)
{
    const struct glide_modes *modes = &chain->units[unit]->modes;

    for (uint32 n = 0; n < chain->count; n++)
        if (chain->units[n]->modes.dither)
            return 0;
    if (!modes->perspective || modes->table_quotients || !modes->subdivision)
        return 0;
    return modes->subdivision == 8 ? 3 : 4;
}

/* Prepares a line of count pixels. */
static void open_line(struct line *line, const struct glide_chain *chain,
                      const struct glide_iterations *at, int32 count)
{
    line->chain = chain;
    line->at = at;
    line->count = count;
    line->done = 0;
    for (uint32 n = 0; n < chain->count; n++)
        line->pieces[n].bits = at->divided[chain->own >> n & 1 ? n : 0]
            ? glide_piece_bits(chain, n) : 0;
}

/* Returns the step from pixel to pixel that takes a value from one number to another, rounded down;
   0 if pixels is 0. */
static int32 step_between(int32 from, int32 to, int32 pixels)
{
    const int32 way = (int32)((uint32)to - (uint32)from), step = pixels ? way / pixels : 0;

    return step * pixels > way ? step - 1 : step;
}

static int32 moved(int32 from, uint32 step, int32 pixels)
{
    return (int32)((uint32)from + step * (uint32)pixels);
}

/* Begins a unit's piece at a point. */
static void begin_piece(struct line *line, uint32 unit, const struct glide_point *point,
                        const struct plane *by)
{
    const struct glide *glide = line->chain->units[unit];
    struct piece *piece = &line->pieces[unit];
    const int32 left = line->count - 1 - line->done, whole = 1 << piece->bits;
    const int32 pixels = left < whole ? left : whole;
    struct glide_point next;
    int32 s, t;

    next.s = moved(point->s, by[GLIDE_S].dx, pixels);
    next.t = moved(point->t, by[GLIDE_T].dx, pixels);
    next.w = moved(point->w, by[GLIDE_W].dx, pixels);
    glide_project(glide, point, &piece->s, &piece->t);
    glide_project(glide, &next, &s, &t);
    piece->ds = step_between(piece->s, s, pixels);
    piece->dt = step_between(piece->t, t, pixels);
}

/* Returns the A R G B of the line's next pixel. */
static uint32 next_pixel(struct line *line)
{
    const struct glide_chain *chain = line->chain;
    uint32 colour = 0;

    for (uint32 n = chain->count; n--;) {
        const uint32 points = chain->own >> n & 1 ? n : 0;
        const struct glide_point *point = &line->at->points[points];
        struct piece *piece = &line->pieces[n];

        if (!piece->bits) {
            colour = glide_pixel(chain->units[n], point, colour);
            continue;
        }
        if (!(line->done & ((1 << piece->bits) - 1)))
            begin_piece(line, n, point, &line->at->planes.of[points ? GLIDE_OWN : GLIDE_S]);
        colour = glide_pixel_at(chain->units[n], point, piece->s, piece->t, colour);
        piece->s = moved(piece->s, (uint32)piece->ds, 1);
        piece->t = moved(piece->t, (uint32)piece->dt, 1);
    }
    line->done++;
    return colour;
}

static void set_point(struct glide_iterations *at, uint32 unit, int32 x, int32 y)
{
    const int32 first = unit ? GLIDE_OWN : GLIDE_S;
    struct glide_point *point = &at->points[unit];

    point->s = (int32)planes_at(&at->planes, first + GLIDE_S, x, y);
    point->t = (int32)planes_at(&at->planes, first + GLIDE_T, x, y);
    point->w = (int32)planes_at(&at->planes, first + GLIDE_W, x, y);
    point->x = x;
    point->y = y;
}

/* Moves a unit's point to the line's next pixel. */
static void step_point(struct glide_iterations *at, uint32 unit)
{
    const struct plane *of = &at->planes.of[unit ? GLIDE_OWN : GLIDE_S];
    struct glide_point *point = &at->points[unit];

    point->s = (int32)((uint32)point->s + of[GLIDE_S].dx);
    point->t = (int32)((uint32)point->t + of[GLIDE_T].dx);
    point->w = (int32)((uint32)point->w + of[GLIDE_W].dx);
    point->x++;
}

/* Returns the frame's pixel with a colour added: see glide_pipe_adds. */
static uint32 added_pixel(const uint8 *to, uint32 argb, int32 pixel_bytes)
{
    const uint32 there = pixel_bytes == 4 ? *(const uint32 *)to
        : glide_wide_565(*(const uint16 *)to);
    uint32 sum = 0;

    argb = argb << 8 | argb >> 24;
    for (int32 shift = 0; shift < 32; shift += 8) {
        const uint32 channel = (there >> shift & 255) + (argb >> shift & 255);

        sum |= (channel < 255 ? channel : 255) << shift;
    }
    return pixel_bytes == 4 ? sum : glide_frame_pixel(sum >> 8, pixel_bytes);
}

void glide_pixels_draw(const struct glide_pipe *pipe, struct glide_iterations *at,
                       const struct frame *frame, int32 x, int32 end, int32 y)
{
    const struct glide_chain *chain = &pipe->chain;
    uint8 *to = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    struct line line;

    open_line(&line, chain, at, end - x);
    set_point(at, 0, x, y);
    if (glide_has_own(chain))
        set_point(at, 1, x, y);
    for (; x < end; x++, to += frame->pixel_bytes) {
        const uint32 argb = next_pixel(&line);
        const uint32 pixel = pipe->adds ? added_pixel(to, argb, frame->pixel_bytes)
            : glide_frame_pixel(argb, frame->pixel_bytes);

        pixel_write(to, 0, frame->pixel_bytes, pixel);
        step_point(at, 0);
        if (glide_has_own(chain))
            step_point(at, 1);
    }
}
