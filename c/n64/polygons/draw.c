/* From a polygon to its lines, and line by line to pixels.

   A pixel depends only on its iterators, which are planes over the polygon, and on
   the engine's state. It is drawn by the plain mappers, by passes over a line's pixels or by
   pixel.h itself; lower.h chooses, and the choice makes no difference to the picture. */
#include "drawing/fan.h"
#include "drawing/lower.h"
#include "drawing/outline.h"
#include "n64/polygons/lower.h"
#include "n64/polygons/plan.h"
#include "n64/polygons/unit.h"
#include "polygon/counts.h"

/* Returns the pixel of a colour (R G B A from the highest byte on): in a frame of 4 bytes a pixel
   the colour itself, in one of 2 5/5/5/1, the lower bits cut off. */
static uint32 pixel_of(uint32 colour, int32 pixel_bytes)
{
    if (pixel_bytes == 4)
        return colour;
    return (colour >> 16 & 0xf800) | (colour >> 13 & 0x7c0) | (colour >> 10 & 0x3e)
        | (colour >> 7 & 1);
}

static const struct planes_scale scale = {5, N64_W_ONE, 1024 << 16};

static void find_greys(struct n64_planes *planes, const struct setup *s, struct planes_corners *corners)
{
    const struct plane *grey = &planes->all.of[N64_RED + 2];

    for (int32 n = 0; n < PLANES_CORNERS; n++) {
        corners->of[n].s = planes_corner(s, s->given, n)->shade;
        corners->of[n].t = 255 << 16;
    }
    planes_pair(&planes->all, s, corners, N64_RED + 2);
    for (int32 i = N64_RED; i < N64_RED + 2; i++) {
        planes->all.of[i].at = grey->at;
        planes->all.of[i].dx = grey->dx;
        planes->all.of[i].dy = grey->dy;
    }
}

static void find_shades(struct n64_planes *planes, const struct setup *s, const uint32 *colours)
{
    struct planes_corners corners;

    planes_open(&corners, s);
    if (!colours) {
        find_greys(planes, s, &corners);
        return;
    }
    for (int32 pair = 0; pair < 2; pair++) {
        for (int32 n = 0; n < PLANES_CORNERS; n++) {
            const uint32 channels = colours[planes_corner(s, s->given, n) - s->given] >> (16 - 16 * pair);

            corners.of[n].s = (fix16)(channels << 8 & 0xff0000);
            corners.of[n].t = (fix16)(channels << 16 & 0xff0000);
        }
        planes_pair(&planes->all, s, &corners, N64_RED + 2 * pair);
    }
}

/* Finds the planes of a polygon whose outline is found. s->given has s and t
   in texels, w and shade, 16.16. planes_coordinates converts them; S is s times 32. If
   perspective is 0, W is 0x7fff0000, and division by it changes nothing.

   shades: non-zero to interpolate colours (R G B A of each vertex; null: the vertices' shades as
   grey, A 255).

   Returns 0 if coordinates of two vertices are 1,024 texels or more apart. */
static int32 find_planes(struct n64_planes *planes, const struct setup *s, int32 perspective,
                         int32 shades, const uint32 *colours)
{
    planes->divided = perspective;
    planes->shaded = shades;
    if (!planes_coordinates(&planes->all, s, N64_S, s->given, &scale, perspective))
        return 0;
    if (shades)
        find_shades(planes, s, colours);
    return 1;
}

static int16 channel(uint32 plane)
{
    int32 value = (int32)plane >> 16;

    return (int16)(value < 0 ? 0 : value > 255 ? 255 : value);
}

static void shade_at(const struct n64_planes *planes, int32 x, int32 y, struct n64_colour *shade)
{
    for (int32 i = 0; i < 4; i++)
        (&shade->r)[i] = channel(planes_at(&planes->all, N64_RED + i, x, y));
}

/* Finds the iterators and their gradients at pixel (x, y). */
static void find_point(const struct n64_planes *planes, int32 x, int32 y, struct n64_point *point)
{
    for (int32 i = N64_S; i <= N64_W; i++) {
        (&point->at.s)[i] = (int32)planes_at(&planes->all, i, x, y);
        (&point->dx.s)[i] = (int32)planes->all.of[i].dx;
        (&point->dy.s)[i] = (int32)planes->all.of[i].dy;
    }
}

void n64_draw_line(const struct n64 *n64, const struct n64_planes *planes,
                   const struct n64_colour *constant, const struct frame *frame, int32 x,
                   int32 end, int32 y)
{
    uint8 *row = frame->pixels + y * frame->pitch;
    struct n64_colour shade = *constant;

    for (; x < end; x++) {
        struct n64_point point;

        find_point(planes, x, y, &point);
        if (planes->shaded)
            shade_at(planes, x, y, &shade);
        pixel_write(row, x, frame->pixel_bytes,
                        pixel_of(n64_draw_pixel(n64, &point, &shade), frame->pixel_bytes));
    }
}

static void draw_pixels(const struct setup *s, const struct n64 *n64,
                        const struct n64_planes *planes, const struct n64_colour *shade)
{
    const struct scanline *line = s->edges.lines;

    for (int32 y = s->box.top; y < s->box.bottom; y++, line++) {
        int32 x = line->left - EDGE_BIAS;

        n64_draw_line(n64, planes, shade, s->frame, x, line->last + 1 - EDGE_BIAS, y);
    }
}

static enum polygon_result draw_flat(const struct setup *s, const struct polygon *polygon,
                                     uint32 colour)
{
    struct material flat = *s->material;

    flat.mapper = MAPPER_FLAT;
    flat.perspective = PERSPECTIVE_NONE;
    flat.colour = pixel_of(colour, s->frame->pixel_bytes);
    return polygon_draw(s->renderer, polygon, &flat);
}

static uint32 constant_colour(const struct n64 *n64, const struct n64_colour *shade)
{
    static const struct n64_colour none;
    struct n64_sources sources;

    sources.texel0 = sources.texel1 = none;
    sources.shade = *shade;
    sources.fraction = 0;
    return n64_combine_pixel(n64, &sources);
}

enum polygon_result n64_refused(struct n64_unit *unit, enum n64_result result)
{
    unit->result = result;
    return POLYGON_REFUSED;
}

static enum polygon_result draw_planes(struct setup *s, struct n64_unit *unit,
                                       const struct n64_needs *needs, const uint32 *colours)
{
    enum polygon_result result;
    struct n64_planes planes;
    struct n64_plan *plan = 0;

    if (unit->n64.modes.cycle == N64_COPY)      /* no page can be drawn from */
        return n64_refused(unit, N64_CYCLE_TYPE);
    result = outline_flat(s);
    if (result != POLYGON_DRAWN)
        return result;
    if (!find_planes(&planes, s, needs->divided, (needs->inputs & N64_INPUT_SHADE) != 0, colours))
        return n64_refused(unit, N64_COORDINATE_RANGE);
    if (RULE_IS_ON(s, N64_PASSES))
        plan = n64_plan_find(needs, unit, &planes, s->frame->pixel_bytes, s->scratch->room);
    if (plan)
        RULE_APPLIES(s, N64_PASSES);
    if (s->counts)
        count_lines(s, plan ? SPAN_N64_PASSES : SPAN_N64_PIXELS);
    if (s->renderer->only_counts)
        return POLYGON_DRAWN;
    if (plan)
        n64_plan_draw(plan, s->frame, s->edges.lines, s->box.top, s->box.bottom - s->box.top,
                      s->box.right - s->box.left);
    else
        draw_pixels(s, &unit->n64, &planes, &needs->shade);
    return POLYGON_DRAWN;
}

uint32 n64_unit_state(const struct n64_unit *unit)
{
    uint32 state = unit->n64.mode_generation + unit->n64.tmem_generation;

    for (int32 i = 0; i < N64_TILES; i++)
        state += unit->n64.tile_generation[i];
    return state;
}

/* Returns N64_DONE if state and vertices can be drawn. Checks the state only if it has changed. */
static enum n64_result judge(struct n64_unit *unit, uint32 state, const struct vertex *v, int32 count)
{
    enum n64_result result = N64_DONE;

    if (state != unit->validated || !unit->used) {
        result = n64_check_drawing(&unit->n64);
        unit->used = n64_tiles_used(&unit->n64);
    }
    if (result == N64_DONE)
        unit->validated = state;
    for (; count > 0 && result == N64_DONE; count--, v++)
        result = n64_check_coordinates(&unit->n64, v->s, v->t);
    return result;
}

/* Returns the values of vertices that are drawn as planes through three corners. */
static uint32 planes_asked(const struct n64 *n64, const uint32 *colours)
{
    const uint32 shades = colours ? PLANAR_COLOURS : PLANAR_SHADES;

    return (n64->modes.perspective ? PLANAR_DEPTHS : PLANAR_TEXELS)
         | (n64->inputs & N64_INPUT_SHADE ? shades : 0);
}

/* Lowered as far as the unit's state and the vertices allow. */
static enum polygon_result draw_lowered(struct setup *s, const struct polygon *polygon,
                                        const uint32 *colours)
{
    struct n64_unit *unit = s->material->unit;
    const struct vertex *paged;
    struct n64_needs needs;

    n64_lower_inputs(&needs, s, &unit->n64, colours);
    if (RULE_IS_ON(s, N64_FLAT) && !needs.inputs) {     /* all pixels have the same colour */
        RULE_APPLIES(s, N64_FLAT);
        return draw_flat(s, polygon, constant_colour(&unit->n64, &needs.shade));
    }
    if (n64_lower_to_plain(&needs, s, unit, &paged))
        return page_draw(s, paged, &unit->page);
    return draw_planes(s, unit, &needs, colours);
}

/* Returns non-zero if no coordinate of a triangle is more than half the reach from 0: then all are less than that
   apart, and in the range of n64_check_coordinates. */
static int32 is_near(const struct vertex *v)
{
    fix16 any = 0;

    for (int32 n = 3; n; n--, v++)
        any |= (v->s ^ v->s >> 31) | (v->t ^ v->t >> 31);
    return any < scale.reach >> 1;
}

/* Returns non-zero if a triangle has the passes of the polygon before, which walk, and no shades. */
static int32 has_same_walk(const struct n64_unit *unit, const struct renderer *renderer, uint32 state)
{
    const struct n64_plan *plan = unit->plan;
    const struct n64 *n64 = &unit->n64;

    return plan && !plan->shaded && plan->coordinates == n64_walk && !n64->modes.perspective
        && plan->key.state == state && plan->key.inputs == n64->inputs
        && (n64->modes.quad || n64->inputs != N64_INPUT_TEXEL0)
        && plan->key.pixel_bytes == renderer->frame->pixel_bytes && plan->key.room == renderer->scratch->room
        && !renderer->off && !renderer->counts && !renderer->only_counts;
}

/* Draws a triangle by the passes of the polygon before. */
static enum polygon_result draw_walk(struct setup *s, struct n64_plan *plan)
{
    const enum polygon_result result = outline_flat(s);
    struct n64_planes planes;
    struct texturing t;

    if (result != POLYGON_DRAWN)
        return result;
    t.u_cut = t.v_cut = 0;
    texturing_plane(&t, &s->sides, &s->box, CHAIN_NONE);
    planes.all.i = t.i;
    planes.all.j = t.j;
    planes.all.of[N64_S].at = t.u << scale.bits;
    planes.all.of[N64_T].at = t.v << scale.bits;
    planes.all.of[N64_S].dx = (uint32)t.dudx << scale.bits;
    planes.all.of[N64_T].dx = (uint32)t.dvdx << scale.bits;
    planes.all.of[N64_S].dy = (uint32)t.dudy << scale.bits;
    planes.all.of[N64_T].dy = (uint32)t.dvdy << scale.bits;
    n64_plan_walk(plan, &planes);
    n64_plan_draw(plan, s->frame, s->edges.lines, s->box.top, s->box.bottom - s->box.top,
                  s->box.right - s->box.left);
    return POLYGON_DRAWN;
}

/* Draws a triangle as the polygon before; returns enum polygon_result, or -1: its state must be asked for. */
static int32 draw_again(struct n64_unit *unit, uint32 state, struct renderer *renderer,
                        const struct polygon *polygon, const struct material *material)
{
    int32 result = -1;
    struct setup s;

    if (unit->paged == state && page_is_same(&unit->page, renderer, polygon, material)) {
        result = n64_page_again(unit, renderer, polygon->vertices);
    } else if (unit->validated == state && has_same_walk(unit, renderer, state)) {
        setup_begin(&s, renderer, polygon, material);
        result = (int32)draw_walk(&s, unit->plan);
    }
    if (result == POLYGON_DRAWN)
        n64_drawn_from(&unit->n64, unit->used);
    return result;
}

/* colours: of the vertices, or 0: shades; routine: what draws the same of other vertices. */
static enum polygon_result draw(struct renderer *renderer, const struct polygon *polygon,
                                const struct material *material, const uint32 *colours,
                                polygon_routine *routine)
{
    struct n64_unit *unit = material->unit;
    enum polygon_result result;
    enum n64_result check;
    struct setup s;
    uint32 state;

    if (unit->n64.modes.cycle == N64_COPY && routine != n64_polygon_copy)
        return n64_refused(unit, N64_CYCLE_TYPE);
    if (polygon->count < 3 || polygon->count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (renderer->frame->pixel_bytes == 1)
        return POLYGON_WRONG_MAP;
    state = n64_unit_state(unit);
    if (polygon->count == 3 && is_near(polygon->vertices)) {
        const int32 again = draw_again(unit, state, renderer, polygon, material);

        if (again >= 0)
            return (enum polygon_result)again;
    }
    check = judge(unit, state, polygon->vertices, polygon->count);
    if (check != N64_DONE)
        return n64_refused(unit, check);
    if (polygon->count > 3 && polygon->planar != PLANAR_ALL
        && !polygon_is_planar(renderer, polygon, polygon->vertices,
                              planes_asked(&unit->n64, colours)))
        return polygon_fan(routine, renderer, polygon, material);
    setup_begin(&s, renderer, polygon, material);
    result = count_rules(&s, draw_lowered(&s, polygon, colours));
    if (result == POLYGON_DRAWN)
        n64_drawn_from(&unit->n64, unit->used);
    return result;
}

enum polygon_result n64_polygon_copy(struct renderer *renderer, const struct polygon *polygon,
                                     const struct material *material)
{
    return draw(renderer, polygon, material, 0, n64_polygon_copy);
}

enum polygon_result n64_polygon_draw(struct renderer *renderer, const struct polygon *polygon,
                                     const struct material *material)
{
    return draw(renderer, polygon, material, 0, n64_polygon_draw);
}

enum polygon_result n64_polygon_draw_coloured(struct renderer *renderer,
                                              const struct polygon *polygon,
                                              const struct material *material)
{
    uint32 colours[POLYGON_VERTICES_MAX];

    for (int32 i = 0; i < polygon->count && i < POLYGON_VERTICES_MAX; i++)
        colours[i] = (uint32)polygon->vertices[i].shade;
    return draw(renderer, polygon, material, colours, n64_polygon_draw_coloured);
}

void n64_unit_init(struct n64_unit *unit, const uint8 *dram, uint32 dram_bytes, int32 memory,
                   uint32 **reciprocals)
{
    uint8 *bytes = (uint8 *)unit;

    for (uint32 i = 0; i < sizeof *unit; i++)
        bytes[i] = 0;
    n64_init(&unit->n64, dram, dram_bytes);
    unit->memory = memory;
    unit->reciprocals = reciprocals;
}
