/* From a polygon to its lines, and line by line to pixels.

   All that decides a pixel is what is iterated, planes over the polygon, and the units' state.
   What draws it is chosen by lower.c and makes no difference to the picture. */
#include "polygon/counts.h"
#include "polygon/lower.h"
#include "polygon/outline.h"
#include "tmu/tiles.h"

/* What is iterated for a unit's points. */
struct iteration {
    int32 first;                /* plane */
    int32 divided;              /* a unit divides by w */
    const struct vertex *corners;
};

static const struct planes_scale scale = {2, 1 << 30, TMU_REACH << 16};

static enum polygon_result refuse(struct tmu_pipe *pipe, enum tmu_result result)
{
    pipe->result = result;
    return POLYGON_REFUSED;
}

/* The vertices of a unit's points. divided: 1 where a unit that has no points of its own divides
   by them. */
static void find_iteration(const struct tmu_pipe *pipe, uint32 unit, const struct vertex *v,
                           struct iteration *of)
{
    const struct tmu_chain *chain = &pipe->chain;

    of->first = unit ? TMU_OWN : TMU_S;
    of->divided = 0;
    for (uint32 n = 0; n < chain->count; n++)
        if ((chain->own >> n & 1 ? n : 0) == unit)
            of->divided |= chain->units[n]->modes.perspective;
    of->corners = v;
}

static int32 is_near(fix16 value)
{
    return value > -(TMU_REACH << 16) && value < TMU_REACH << 16;
}

static enum tmu_result judge(const struct iteration *of, const struct vertex *v, int32 count)
{
    for (; count > 0; count--, v++) {
        if (!is_near(v->s) || !is_near(v->t))
            return TMU_BAD_COORDINATE;
        if (of->divided && (!v->w || v->w > W_MAX || v->w < -W_MAX))
            return TMU_BAD_W;
    }
    return TMU_DONE;
}

static void set_point(struct tmu_iterations *at, uint32 unit, int32 x, int32 y)
{
    const int32 first = unit ? TMU_OWN : TMU_S;
    struct tmu_point *point = &at->points[unit];

    point->s = (int32)planes_at(&at->planes, first + TMU_S, x, y);
    point->t = (int32)planes_at(&at->planes, first + TMU_T, x, y);
    point->w = (int32)planes_at(&at->planes, first + TMU_W, x, y);
    point->x = x;
    point->y = y;
}

/* The next pixel of a line. */
static void step_point(struct tmu_iterations *at, uint32 unit)
{
    const struct plane *of = &at->planes.of[unit ? TMU_OWN : TMU_S];
    struct tmu_point *point = &at->points[unit];

    point->s = (int32)((uint32)point->s + of[TMU_S].dx);
    point->t = (int32)((uint32)point->t + of[TMU_T].dx);
    point->w = (int32)((uint32)point->w + of[TMU_W].dx);
    point->x++;
}

/* What the frame's pixel becomes where a colour is added: see tmu_pipe_adds. */
static uint32 added_pixel(const uint8 *to, uint32 argb, int32 pixel_bytes)
{
    const uint32 there = pixel_bytes == 4 ? *(const uint32 *)to
        : tmu_wide_565(*(const uint16 *)to);
    uint32 sum = 0;

    argb = argb << 8 | argb >> 24;
    for (int32 shift = 0; shift < 32; shift += 8) {
        const uint32 channel = (there >> shift & 255) + (argb >> shift & 255);

        sum |= (channel < 255 ? channel : 255) << shift;
    }
    return pixel_bytes == 4 ? sum : tmu_frame_pixel(sum >> 8, pixel_bytes);
}

/* A line pixel by pixel: whatever the modes are. */
static void draw_line(const struct tmu_pipe *pipe, struct tmu_iterations *at,
                      const struct frame *frame, int32 x, int32 end, int32 y)
{
    const struct tmu_chain *chain = &pipe->chain;
    uint8 *to = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    struct tmu_pieces pieces;

    tmu_pieces_open(&pieces, chain, at, end - x);
    set_point(at, 0, x, y);
    if (tmu_has_own(chain))
        set_point(at, 1, x, y);
    for (; x < end; x++, to += frame->pixel_bytes) {
        const uint32 argb = tmu_pieces_pixel(&pieces);
        const uint32 pixel = pipe->adds ? added_pixel(to, argb, frame->pixel_bytes)
            : tmu_frame_pixel(argb, frame->pixel_bytes);

        if (frame->pixel_bytes == 4)
            *(uint32 *)to = pixel;
        else
            *(uint16 *)to = (uint16)pixel;
        step_point(at, 0);
        if (tmu_has_own(chain))
            step_point(at, 1);
    }
}

int32 tmu_line_draw(const struct tmu_pipe *pipe, struct tmu_plan *plan, struct tmu_iterations *at,
                    const struct frame *frame, int32 x, int32 y, int32 count)
{
    if (plan && tmu_plan_draw(plan, frame, x, y, count))
        return 0;
    draw_line(pipe, at, frame, x, x + count, y);
    return count;
}

static int32 lod_base(const struct plane *of)
{
    return tmu_lod_base((int32)of[TMU_S].dx, (int32)of[TMU_T].dx, (int32)of[TMU_S].dy,
                        (int32)of[TMU_T].dy);
}

/* W of 1.0: a divide changes nothing. */
static int32 is_constant(const struct plane *w)
{
    return w->at == (uint32)scale.one && !w->dx && !w->dy;
}

static int32 least_of(int32 a, int32 b)
{
    return a < b ? a : b;
}

/* W of the box's pixels. No pixel of the polygon has more than 2^30, but for what steps are rounded
   by, so that a change by less than that wraps nowhere. */
static void find_range(struct tmu_range *range, const struct tmu_iterations *at,
                       const struct setup *s, const struct plane *w)
{
    const int32 left = s->box.left - at->planes.i, right = s->box.right - 1 - at->planes.i;
    const int32 top = s->box.top - at->planes.j, bottom = s->box.bottom - 1 - at->planes.j;
    const uint32 columns = (uint32)(right - left + 1), rows = (uint32)(bottom - top + 1);
    const int32 dx = (int32)w->dx, dy = (int32)w->dy;
    const uint32 most = (1u << 30) - 2 * SCENE_SIDE_MAX;
    const uint32 across = magnitude(dx), down = magnitude(dy);

    range->least = range->most = 0;
    if (across >= most / columns || down >= most / rows || across * columns + down * rows >= most)
        return;
    range->least = (int32)w->at + least_of(dx * left, dx * right) + least_of(dy * top, dy * bottom);
    range->most = (int32)w->at - least_of(-dx * left, -dx * right)
        - least_of(-dy * top, -dy * bottom);
    if (range->least < 0)
        range->least = 0;
}

static int32 find_planes(struct tmu_iterations *at, const struct setup *s,
                         const struct iteration *of, uint32 unit)
{
    const struct plane *w = &at->planes.of[of->first + TMU_W];

    if (!planes_coordinates(&at->planes, s, of->first, of->corners, &scale, of->divided))
        return 0;
    at->points[unit].lod = lod_base(&at->planes.of[of->first]);
    find_range(&at->ranges[unit], at, s, w);
    at->divided[unit] = of->divided && !is_constant(w);
    return 1;
}

/* Draws lines; gives how many pixels were drawn one by one. */
static uint32 draw_lines(const struct tmu_pipe *pipe, struct tmu_plan *plan,
                         struct tmu_iterations *at, const struct setup *s)
{
    const struct scanline *line = s->edges.lines;
    uint32 missed = 0;

    for (int32 y = s->box.top; y < s->box.bottom; y++, line++) {
        const int32 x = line->left - EDGE_BIAS, count = line->last - line->left + 1;

        if (count > 0)
            missed += (uint32)tmu_line_draw(pipe, plan, at, s->frame, x, y, count);
    }
    return missed;
}

/* The same of a polygon that is added. */
static uint32 add_lines(const struct tmu_pipe *pipe, struct tmu_plan *plan,
                        struct tmu_iterations *at, const struct setup *s)
{
    const struct scanline *line = s->edges.lines;
    uint32 missed = 0;

    for (int32 y = s->box.top; y < s->box.bottom; y++, line++) {
        const int32 x = line->left - EDGE_BIAS, count = line->last - line->left + 1;

        if (count <= 0 || (plan && tmu_plan_add(plan, s->frame, x, y, count)))
            continue;
        draw_line(pipe, at, s->frame, x, x + count, y);
        missed += (uint32)count;
    }
    return missed;
}

static enum polygon_result draw_planes(struct setup *s, struct tmu_pipe *pipe,
                                       const struct iteration *of)
{
    static struct tmu_iterations at;
    static struct tmu_tiling tiling;
    static struct tmu_plan plan;
    enum polygon_result result;
    int32 passes, tiles;
    uint32 missed;

    result = outline_flat(s);
    if (result != POLYGON_DRAWN)
        return result;
    if (!find_planes(&at, s, &of[0], 0)
        || (tmu_has_own(&pipe->chain) && !find_planes(&at, s, &of[1], 1)))
        return refuse(pipe, TMU_BAD_COORDINATE);
    passes = APPLIES(TMU_PASSES, tmu_plan_find(&plan, pipe, &at, s->frame->pixel_bytes));
    tiles = passes && !pipe->adds
        && APPLIES(TMU_TILES, tmu_tiles_pay(&tiling, pipe, &plan, &at, s));
    if (tiles)
        missed = tmu_tiles_draw(&tiling, s);
    else
        missed = (pipe->adds ? add_lines : draw_lines)(pipe, passes ? &plan : 0, &at, s);
    if (s->counts) {
        s->counts->polygons++;
        s->counts->pixels[SPAN_TMU_PIXELS] += missed;
        s->counts->pixels[tiles ? SPAN_TMU_TILES : SPAN_TMU_PASSES] += lines_pixels(
            s->edges.lines, s->box.bottom - s->box.top) - missed;
    }
    return POLYGON_DRAWN;
}

enum polygon_result tmu_polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                     int32 count, const struct material *material,
                                     const struct drawing *drawing)
{
    struct tmu_pipe *pipe = material->pipe;
    struct iteration of[TMU_UNITS];
    enum tmu_result check;
    struct material plain;
    struct setup s;

    if (count < 3 || count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (frame->pixel_bytes == 1)
        return POLYGON_WRONG_MAP;
    find_iteration(pipe, 0, vertices, &of[0]);
    check = judge(&of[0], vertices, count);
    if (check == TMU_DONE && tmu_has_own(&pipe->chain)) {
        find_iteration(pipe, 1, pipe->own, &of[1]);
        check = pipe->own ? judge(&of[1], pipe->own, count) : TMU_NO_COORDINATES;
    }
    if (check != TMU_DONE)
        return refuse(pipe, check);
    setup_begin(&s, frame, vertices, count, material, drawing);
    if (tmu_lower_to_plain(&s, pipe, &plain, &vertices))
        return polygon_draw(frame, vertices, count, &plain, drawing);
    return draw_planes(&s, pipe, of);
}

enum tmu_result tmu_pipe_init(struct tmu_pipe *pipe, struct tmu *const *units, uint32 count,
                              int32 memory)
{
    static const struct tmu_kept none;

    pipe->own = 0;
    pipe->result = TMU_DONE;
    pipe->memory = memory;
    pipe->prefilter = TMU_TILES_BYTES;
    pipe->adds = 0;
    pipe->settled = 0;
    for (int32 unit = 0; unit < TMU_UNITS; unit++) {
        pipe->bands[unit].count = 0;
        for (int32 level = 0; level <= TMU_LEVEL_LAST; level++)
            pipe->levels[unit][level] = none;
    }
    page_init(&pipe->page.page);
    for (int32 i = 0; i < TMU_PAGE_KEY; i++)
        pipe->page.key[i] = 0;
    return tmu_chain_init(&pipe->chain, units, count);
}

void tmu_pipe_prefilter(struct tmu_pipe *pipe, uint32 bytes)
{
    pipe->prefilter = bytes;
}

enum tmu_result tmu_pipe_adds(struct tmu_pipe *pipe, uint32 adds)
{
    if (adds > 1)
        return TMU_BAD_FLAG;
    pipe->adds = (int32)adds;
    return TMU_DONE;
}
