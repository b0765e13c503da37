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
    of->corners = v;
    of->divided = chain->units[unit]->modes.perspective;
    if (chain->count == 1)
        return;
    for (uint32 n = 0; n < chain->count; n++)
        if ((chain->own >> n & 1 ? n : 0) == unit)
            of->divided |= chain->units[n]->modes.perspective;
}

/* Returns non-zero if no coordinate of a triangle is more than half the reach from 0: then all are less than that
   apart. */
static int32 is_near_half(const struct vertex *v)
{
    fix16 any = 0;

    for (int32 n = 3; n; n--, v++)
        any |= (v->s ^ v->s >> 31) | (v->t ^ v->t >> 31);
    return any < GLIDE_REACH << 15;
}

static int32 is_near(fix16 value)
{
    return value > -(GLIDE_REACH << 16) && value < GLIDE_REACH << 16;
}

static enum glide_result judge(const struct iteration *of, const struct vertex *v, int32 count)
{
    const int32 divided = of->divided;

    for (; count > 0; count--, v++) {
        if (!is_near(v->s) || !is_near(v->t))
            return GLIDE_BAD_COORDINATE;
        if (divided && (!v->w || v->w > W_MAX || v->w < -W_MAX))
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

    range->least = range->most = is_constant(w) ? (int32)w->at : 0;
    if (range->least || across >= most / columns || down >= most / rows || across * columns + down * rows >= most)
        return;
    range->least = (int32)w->at + outline_least(dx * left, dx * right) + outline_least(dy * top, dy * bottom);
    range->most = (int32)w->at - outline_least(-dx * left, -dx * right)
        - outline_least(-dy * top, -dy * bottom);
    if (range->least < 0)
        range->least = 0;
}

static int32 find_planes(struct glide_iterations *at, const struct setup *s,
                         const struct iteration *of, uint32 unit)
{
    if (!planes_coordinates(&at->planes, s, of->first, of->corners, &scale, of->divided))
        return 0;
    at->divided[unit] = of->divided && !is_constant(&at->planes.of[of->first + GLIDE_W]);
    return 1;
}

/* Finds what levels of detail depend on. */
static void find_levels(struct glide_iterations *at, const struct setup *s, int32 has_own)
{
    for (int32 unit = 0; unit <= has_own; unit++) {
        const struct plane *of = &at->planes.of[unit ? GLIDE_OWN : GLIDE_S];

        at->points[unit].lod = lod_base(of);
        find_range(&at->ranges[unit], at, s, &of[GLIDE_W]);
    }
}

/* Draws lines by passes, or, where there are none (plan is 0, or memory is short), pixel by pixel
   unless they are only counted; returns how many of those. */
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
        if (!s->renderer->only_counts)
            glide_pixels_draw(pipe, at, s->frame, x, x + count, y);
        missed += (uint32)count;
    }
    return missed;
}

/* The scratch room of one polygon. */
struct room {
    struct glide_iterations at;
    struct glide_tiling tiling;
    struct glide_plan plan;
    struct frame unseen;
    struct glide_line_scratch line;
};

SCRATCH_FITS_UNIT(struct room);

/* Counting draws these lines into scratch memory: whether a line has passes is only known when it is
   drawn. */
static void hide_lines(struct setup *s, struct room *room)
{
    struct frame *unseen = &room->unseen;

    unseen->pixels = (uint8 *)room->line.unseen;
    unseen->width = s->frame->width;
    unseen->height = s->frame->height;
    unseen->pixel_bytes = s->frame->pixel_bytes;
    unseen->pitch = 0;
    s->frame = unseen;
}

static void count(const struct setup *s, enum span_kind kind, uint32 missed)
{
    count_lines(s, kind);
    s->counts->pixels[kind] -= missed;
    s->counts->pixels[SPAN_GLIDE_PIXELS] += missed;
}

/* Draws a polygon by a plan of its own; returns the kind of spans. */
static enum span_kind draw_planned(struct setup *s, struct room *room, struct glide_pipe *pipe,
                                   int32 asks_tiles, uint32 *missed)
{
    int32 passes;

    find_levels(&room->at, s, glide_has_own(&pipe->chain));
    room->plan.scratch = &room->line;
    passes = RULE_IS_ON(s, GLIDE_PASSES)
        && glide_plan_find(&room->plan, pipe, &room->at, s->frame->pixel_bytes);
    if (passes)
        RULE_APPLIES(s, GLIDE_PASSES);
    if (passes && asks_tiles && glide_tiles_pay(&room->tiling, pipe, &room->plan, &room->at, s)) {
        RULE_APPLIES(s, GLIDE_TILES);
        if (s->renderer->only_counts)
            hide_lines(s, room);
        *missed = glide_tiles_draw(&room->tiling, s);
        return SPAN_GLIDE_TILES;
    }
    if (s->renderer->only_counts)
        hide_lines(s, room);
    if (passes && !pipe->adds
        && (glide_lines_kept(pipe, &room->at, s) || glide_lines_find(pipe, &room->plan, s)))
        glide_lines_draw(&pipe->lines, &room->at.planes, s, &room->line);
    else
        *missed = draw_lines(pipe, passes ? &room->plan : 0, &room->at, s);
    return SPAN_GLIDE_PASSES;
}

/* Draws a polygon whose outline is found. */
static enum polygon_result draw_planes(struct setup *s, struct glide_pipe *pipe,
                                       const struct iteration *of)
{
    struct room *room = (struct room *)s->scratch->room;
    enum span_kind kind = SPAN_GLIDE_PASSES;
    uint32 missed = 0;
    int32 asks_tiles;

    room->at.divided[1] = 0;
    if (!find_planes(&room->at, s, &of[0], 0)
        || (glide_has_own(&pipe->chain) && !find_planes(&room->at, s, &of[1], 1)))
        return refuse(pipe, GLIDE_BAD_COORDINATE);
    asks_tiles = !pipe->adds && RULE_IS_ON(s, GLIDE_TILES) && glide_tiles_may_pay(pipe, &room->at, s);
    if (!asks_tiles && !pipe->adds && RULE_IS_ON(s, GLIDE_PASSES)
        && glide_lines_kept(pipe, &room->at, s)) {
        RULE_APPLIES(s, GLIDE_PASSES);
        if (s->renderer->only_counts)
            hide_lines(s, room);
        glide_lines_draw(&pipe->lines, &room->at.planes, s, &room->line);
    } else {
        kind = draw_planned(s, room, pipe, asks_tiles, &missed);
    }
    if (s->counts)
        count(s, kind, missed);
    return POLYGON_DRAWN;
}

/* Which triangles are drawn without asking for their passes. */
enum again { ANEW, AGAIN_LEVEL, AGAIN_DIVIDED };

static enum again asks_again(const struct glide_pipe *pipe, const struct renderer *renderer, const struct vertex *v)
{
    const struct glide_lines *lines = &pipe->lines;
    const struct glide_chain *chain = &pipe->chain;

    if (!lines->is_kept || lines->scratch != renderer->scratch
        || lines->bits != renderer->frame->pixel_bytes >> 1 || renderer->off || renderer->counts
        || renderer->only_counts
        || lines->states[0] != glide_state(chain->units[0])
        || (chain->count > 1 && (chain->own || lines->own || lines->states[1] != glide_state(chain->units[1]))))
        return ANEW;
    if (!lines->divided[0])
        return lines->is_plain || chain->units[0]->modes.perspective
            || (chain->count > 1 && chain->units[1]->modes.perspective) ? ANEW : AGAIN_LEVEL;
    for (int32 n = 0; n < 3; n++)
        if (!v[n].w || v[n].w > W_MAX || v[n].w < -W_MAX)
            return ANEW;
    return v->w == v[1].w && v->w == v[2].w ? ANEW : AGAIN_DIVIDED;
}

/* Draws a triangle by passes that are those of the polygon before. */
static enum polygon_result draw_again(struct setup *s, struct glide_pipe *pipe, enum again again)
{
    struct room *room = (struct room *)s->scratch->room;
    struct iteration of;
    const enum polygon_result result = outline_flat(s);

    if (result != POLYGON_DRAWN)
        return result;
    of.first = GLIDE_S;
    of.corners = s->given;
    of.divided = again == AGAIN_DIVIDED;
    room->at.divided[0] = of.divided;
    if (of.divided || glide_tiles_may_pay(pipe, &room->at, s))
        return draw_planes(s, pipe, &of);
    glide_lines_draw_level(&pipe->lines, s, &room->line);
    return POLYGON_DRAWN;
}

/* Returns non-zero if what units iterate lies on planes. */
static int32 is_planar(const struct renderer *renderer, const struct polygon *polygon,
                       const struct iteration *of)
{
    return polygon_is_planar(renderer, polygon, of->corners,
                             of->divided ? PLANAR_DEPTHS : PLANAR_TEXELS);
}

enum polygon_result glide_polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                       const struct material *material)
{
    struct glide_pipe *pipe = material->pipe;
    const int32 has_own = glide_has_own(&pipe->chain);
    const struct vertex *second = polygon->second;
    struct iteration of[GLIDE_UNITS];
    enum glide_result check;
    const struct vertex *paged;
    enum polygon_result result;
    struct setup s;

    if (polygon->count == 3 && is_near_half(polygon->vertices)) {
        enum again again;

        if (pipe->paged == glide_state(pipe->chain.units[0])
            && page_is_same(&pipe->page, renderer, polygon, material)) {
            const int32 result = glide_page_again(pipe, renderer, polygon->vertices);

            if (result >= 0)
                return (enum polygon_result)result;
        }
        again = asks_again(pipe, renderer, polygon->vertices);
        if (again != ANEW) {
            setup_begin(&s, renderer, polygon, material);
            return draw_again(&s, pipe, again);
        }
    }
    if (polygon->count < 3 || polygon->count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (renderer->frame->pixel_bytes == 1)
        return POLYGON_WRONG_MAP;
    find_iteration(pipe, 0, polygon->vertices, &of[0]);
    check = judge(&of[0], polygon->vertices, polygon->count);
    if (check == GLIDE_DONE && has_own) {
        find_iteration(pipe, 1, second, &of[1]);
        check = second ? judge(&of[1], second, polygon->count) : GLIDE_NO_COORDINATES;
    }
    if (check != GLIDE_DONE)
        return refuse(pipe, check);
    if (polygon->count > 3 && polygon->planar != PLANAR_ALL
        && !(is_planar(renderer, polygon, &of[0])
             && (!has_own || is_planar(renderer, polygon, &of[1]))))
        return polygon_fan(glide_polygon_draw, renderer, polygon, material);
    setup_begin(&s, renderer, polygon, material);
    if (glide_may_be_plain(pipe) && glide_lower_to_plain(&s, pipe, &paged))
        return count_rules(&s, page_draw(&s, paged, &pipe->page));
    result = outline_flat(&s);
    return count_rules(&s, result == POLYGON_DRAWN ? draw_planes(&s, pipe, of) : result);
}
