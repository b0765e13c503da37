/* From a polygon to its lines, and line by line to pixels.

   A pixel depends only on the iterated values, which are planes over the polygon, and on the units'
   state. lower.c chooses the routines that draw it; the choice makes no difference to the
   picture. */
#include "drawing/fan.h"
#include "drawing/lower.h"
#include "drawing/outline.h"
#include "glide/polygons/tiles.h"
#include "polygon/counts.h"

/* The iteration of a unit's points. */
struct iteration {
    int32 first;                /* plane */
    int32 divided;              /* a unit divides by w */
    const struct vertex *corners;
};

static const struct planes_scale scale = {2, 1 << 30, GLIDE_REACH << 16};

static enum polygon_result refuse(struct glide_pipe *pipe, enum glide_result result)
{
    pipe->result = result;
    return POLYGON_REFUSED;
}

/* Finds the iteration of a unit's points, given by the vertices v. divided is 1 if any unit that
   uses these points divides by w. */
static void find_iteration(const struct glide_pipe *pipe, uint32 unit, const struct vertex *v,
                           struct iteration *of)
{
    const struct glide_chain *chain = &pipe->chain;

    of->first = unit ? GLIDE_OWN : GLIDE_S;
    of->divided = 0;
    for (uint32 n = 0; n < chain->count; n++)
        if ((chain->own >> n & 1 ? n : 0) == unit)
            of->divided |= chain->units[n]->modes.perspective;
    of->corners = v;
}

static int32 is_near(fix16 value)
{
    return value > -(GLIDE_REACH << 16) && value < GLIDE_REACH << 16;
}

static enum glide_result judge(const struct iteration *of, const struct vertex *v, int32 count)
{
    for (; count > 0; count--, v++) {
        if (!is_near(v->s) || !is_near(v->t))
            return GLIDE_BAD_COORDINATE;
        if (of->divided && (!v->w || v->w > W_MAX || v->w < -W_MAX))
            return GLIDE_BAD_W;
    }
    return GLIDE_DONE;
}

static int32 lod_base(const struct plane *of)
{
    return glide_lod_base((int32)of[GLIDE_S].dx, (int32)of[GLIDE_T].dx, (int32)of[GLIDE_S].dy,
                          (int32)of[GLIDE_T].dy);
}

/* Returns non-zero if W is 1.0 everywhere: division by it changes nothing. */
static int32 is_constant(const struct plane *w)
{
    return w->at == (uint32)scale.one && !w->dx && !w->dy;
}

static int32 least_of(int32 a, int32 b)
{
    return a < b ? a : b;
}

/* Finds the range of W over the box's pixels. Apart from the rounding of steps no pixel of the
   polygon has more than 2^30, so a change by less than that wraps nowhere. */
static void find_range(struct glide_range *range, const struct glide_iterations *at,
                       const struct setup *s, const struct plane *w)
{
    const int32 left = s->box.left - at->planes.i, right = s->box.right - 1 - at->planes.i;
    const int32 top = s->box.top - at->planes.j, bottom = s->box.bottom - 1 - at->planes.j;
    const uint32 columns = (uint32)(right - left + 1), rows = (uint32)(bottom - top + 1);
    const int32 dx = (int32)w->dx, dy = (int32)w->dy;
    const uint32 most = (1u << 30) - 2 * FRAME_SIDE_MAX;
    const uint32 across = fix_magnitude(dx), down = fix_magnitude(dy);

    range->least = range->most = 0;
    if (across >= most / columns || down >= most / rows || across * columns + down * rows >= most)
        return;
    range->least = (int32)w->at + least_of(dx * left, dx * right) + least_of(dy * top, dy * bottom);
    range->most = (int32)w->at - least_of(-dx * left, -dx * right)
        - least_of(-dy * top, -dy * bottom);
    if (range->least < 0)
        range->least = 0;
}

static int32 find_planes(struct glide_iterations *at, const struct setup *s,
                         const struct iteration *of, uint32 unit)
{
    const struct plane *w = &at->planes.of[of->first + GLIDE_W];

    if (!planes_coordinates(&at->planes, s, of->first, of->corners, &scale, of->divided))
        return 0;
    at->points[unit].lod = lod_base(&at->planes.of[of->first]);
    find_range(&at->ranges[unit], at, s, w);
    at->divided[unit] = of->divided && !is_constant(w);
    return 1;
}

/* Draws lines by passes, or pixel by pixel if there are none (plan is null, or no memory). Returns
   how many pixels were drawn one by one. */
static uint32 draw_lines(const struct glide_pipe *pipe, struct glide_plan *plan,
                         struct glide_iterations *at, const struct setup *s)
{
    glide_plan_routine *const draw = pipe->adds ? glide_plan_add : glide_plan_draw;
    const struct scanline *line = s->edges.lines;
    uint32 missed = 0;

    for (int32 y = s->box.top; y < s->box.bottom; y++, line++) {
        const int32 x = line->left - EDGE_BIAS, count = line->last - line->left + 1;

        if (count <= 0 || (plan && draw(plan, s->frame, x, y, count)))
            continue;
        glide_pixels_draw(pipe, at, s->frame, x, x + count, y);
        missed += (uint32)count;
    }
    return missed;
}

static enum polygon_result draw_planes(struct setup *s, struct glide_pipe *pipe,
                                       const struct iteration *of)
{
    static struct glide_iterations at;
    static struct glide_tiling tiling;
    static struct glide_plan plan;
    enum polygon_result result;
    int32 passes, tiles;
    uint32 missed;

    result = outline_flat(s);
    if (result != POLYGON_DRAWN)
        return result;
    if (!find_planes(&at, s, &of[0], 0)
        || (glide_has_own(&pipe->chain) && !find_planes(&at, s, &of[1], 1)))
        return refuse(pipe, GLIDE_BAD_COORDINATE);
    passes = APPLIES(GLIDE_PASSES, glide_plan_find(&plan, pipe, &at, s->frame->pixel_bytes));
    tiles = passes && !pipe->adds
        && APPLIES(GLIDE_TILES, glide_tiles_pay(&tiling, pipe, &plan, &at, s));
    missed = tiles ? glide_tiles_draw(&tiling, s) : draw_lines(pipe, passes ? &plan : 0, &at, s);
    if (s->counts) {
        s->counts->polygons++;
        s->counts->pixels[SPAN_GLIDE_PIXELS] += missed;
        s->counts->pixels[tiles ? SPAN_GLIDE_TILES : SPAN_GLIDE_PASSES] += lines_pixels(
            s->edges.lines, s->box.bottom - s->box.top) - missed;
    }
    return POLYGON_DRAWN;
}

/* Returns non-zero if the iterated values are on planes. */
static int32 is_planar(const struct iteration *of, const struct vertex *vertices, int32 count,
                       const struct drawing *drawing)
{
    return planar_is(drawing, vertices, of->corners, count,
                     of->divided ? PLANAR_DEPTHS : PLANAR_TEXELS);
}

/* Like polygon_fan, but also splits the separate points into triangles. */
static enum polygon_result draw_fan(const struct frame *frame, const struct vertex *vertices,
                                    int32 count, const struct material *material,
                                    const struct drawing *drawing)
{
    struct glide_pipe *pipe = material->pipe;
    const struct vertex *const own = pipe->own;
    enum polygon_result all = POLYGON_EMPTY;
    struct vertex triangle[3], points[3];

    for (int32 i = 2; i < count; i++) {
        planar_triangle(triangle, vertices, i);
        planar_triangle(points, own, i);
        pipe->own = points;
        all = planar_both(all, glide_polygon_draw(frame, triangle, 3, material, drawing));
    }
    pipe->own = own;
    return all;
}

enum polygon_result glide_polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                       int32 count, const struct material *material,
                                       const struct drawing *drawing)
{
    struct glide_pipe *pipe = material->pipe;
    const int32 has_own = glide_has_own(&pipe->chain);
    struct iteration of[GLIDE_UNITS];
    enum glide_result check;
    struct material plain;
    struct drawing whole;
    struct setup s;

    if (count < 3 || count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (frame->pixel_bytes == 1)
        return POLYGON_WRONG_MAP;
    find_iteration(pipe, 0, vertices, &of[0]);
    check = judge(&of[0], vertices, count);
    if (check == GLIDE_DONE && has_own) {
        find_iteration(pipe, 1, pipe->own, &of[1]);
        check = pipe->own ? judge(&of[1], pipe->own, count) : GLIDE_NO_COORDINATES;
    }
    if (check != GLIDE_DONE)
        return refuse(pipe, check);
    if (count > 3 && drawing->planar != PLANAR_ALL) {
        if (has_own && !(is_planar(&of[0], vertices, count, drawing)
                         && is_planar(&of[1], vertices, count, drawing)))
            return draw_fan(frame, vertices, count, material, drawing);
        if (!has_own && !is_planar(&of[0], vertices, count, drawing))
            return polygon_fan(glide_polygon_draw, frame, vertices, count, material, drawing);
    }
    setup_begin(&s, frame, vertices, count, material, drawing);
    if (glide_lower_to_plain(&s, pipe, &plain, &vertices))
        return polygon_draw(frame, vertices, count, &plain,
                            planar_vouched(&whole, drawing, PLANAR_ALL));
    return draw_planes(&s, pipe, of);
}
