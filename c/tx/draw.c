/* From a polygon to its lines, and line by line to pixels.

   All that decides a pixel is its iterators, planes over the polygon (planes.h), and the
   engine's state. What draws it, the plain mappers, passes over a line's pixels or pixel.h
   itself, is chosen by lower.h and makes no difference to the picture. */
#include "polygon/counts.h"
#include "polygon/fan.h"
#include "polygon/lower.h"
#include "polygon/outline.h"
#include "tx/lower.h"
#include "tx/pixels.h"
#include "tx/plan.h"
#include "tx/planes.h"
#include "tx/unit.h"

static int16 channel(uint32 plane)
{
    int32 value = (int32)plane >> 16;

    return (int16)(value < 0 ? 0 : value > 255 ? 255 : value);
}

static void shade_at(const struct tx_planes *planes, int32 x, int32 y, struct tx_colour *shade)
{
    shade->r = channel(tx_plane_at(planes, TX_RED, x, y));
    shade->g = channel(tx_plane_at(planes, TX_GREEN, x, y));
    shade->b = channel(tx_plane_at(planes, TX_BLUE, x, y));
    shade->a = channel(tx_plane_at(planes, TX_ALPHA, x, y));
}

void tx_draw_line(const struct tx *tx, const struct tx_planes *planes,
                  const struct tx_colour *constant, const struct frame *frame, int32 x,
                  int32 end, int32 y)
{
    uint8 *row = frame->pixels + y * frame->pitch;
    struct tx_colour shade = *constant;

    for (; x < end; x++) {
        struct tx_point point;

        tx_planes_point(planes, x, y, &point);
        if (planes->shaded)
            shade_at(planes, x, y, &shade);
        tx_pixel_write(row, x, frame->pixel_bytes,
                       tx_pixel_of(tx_draw_pixel(tx, &point, &shade), frame->pixel_bytes));
    }
}

/* plan: 0 where there is none. */
static void draw_lines(const struct setup *s, const struct tx *tx,
                       const struct tx_planes *planes, const struct tx_colour *shade,
                       const struct tx_plan *plan)
{
    const struct scanline *line = s->edges.lines;

    for (int32 y = s->box.top; y < s->box.bottom; y++, line++) {
        int32 x = line->left - EDGE_BIAS, count = line->last - line->left + 1;

        if (count > 0 && plan)
            tx_plan_draw(plan, s->frame, x, y, count);
        else
            tx_draw_line(tx, planes, shade, s->frame, x, x + count, y);
    }
}

static enum polygon_result draw_flat(const struct setup *s, uint32 colour,
                                     const struct drawing *drawing)
{
    struct material flat = *s->material;

    flat.mapper = MAPPER_FLAT;
    flat.perspective = PERSPECTIVE_NONE;
    flat.colour = tx_pixel_of(colour, s->frame->pixel_bytes);
    return polygon_draw(s->frame, s->given, s->count, &flat, drawing);
}

static uint32 constant_colour(const struct tx *tx, const struct tx_colour *shade)
{
    static const struct tx_colour none;
    struct tx_sources sources;

    sources.texel0 = sources.texel1 = none;
    sources.shade = *shade;
    sources.fraction = 0;
    return tx_combine_pixel(tx, &sources);
}

enum polygon_result tx_refused(struct tx_unit *unit, enum tx_result result)
{
    unit->result = result;
    return POLYGON_REFUSED;
}

static enum polygon_result draw_planes(struct setup *s, struct tx_unit *unit,
                                       const struct tx_needs *needs, const uint32 *colours)
{
    enum polygon_result result;
    struct tx_planes planes;
    struct tx_plan plan;
    int32 passes;

    if (unit->tx.modes.cycle == TX_COPY)        /* not by a page */
        return tx_refused(unit, TX_CYCLE_TYPE);
    result = outline_flat(s);
    if (result != POLYGON_DRAWN)
        return result;
    if (!tx_planes_find(&planes, s, needs->divided,
                        (needs->inputs & TX_INPUT_SHADE) != 0, colours))
        return tx_refused(unit, TX_COORDINATE_RANGE);
    passes = APPLIES(TX_PASSES, tx_plan_find(&plan, needs, unit, &planes));
    draw_lines(s, &unit->tx, &planes, &needs->shade, passes ? &plan : 0);
    if (s->counts) {
        s->counts->polygons++;
        s->counts->pixels[passes ? SPAN_TX_PASSES : SPAN_TX_PIXELS] += lines_pixels(s->edges.lines,
                                                          s->box.bottom - s->box.top);
    }
    return POLYGON_DRAWN;
}

/* Whether state and vertices can be drawn; the state is looked at when it has changed. */
static enum tx_result judge(struct tx_unit *unit, const struct vertex *v, int32 count)
{
    enum tx_result result = TX_DONE;
    uint32 state = unit->tx.mode_generation + unit->tx.tmem_generation;

    for (int32 i = 0; i < TX_TILES; i++)
        state += unit->tx.tile_generation[i];
    if (state != unit->judged)
        result = tx_check_drawing(&unit->tx);
    if (result == TX_DONE)
        unit->judged = state;
    for (; count > 0 && result == TX_DONE; count--, v++)
        result = tx_check_coordinates(&unit->tx, v->s, v->t);
    return result;
}

/* What is drawn as planes through three corners. */
static uint32 planes_asked(const struct tx *tx, const uint32 *colours)
{
    const uint32 shades = colours ? PLANAR_COLOURS : PLANAR_SHADES;

    return (tx->modes.perspective ? PLANAR_DEPTHS : PLANAR_TEXELS)
         | (tx->inputs & TX_INPUT_SHADE ? shades : 0);
}

/* colours: of the vertices, or 0: shades; routine: what draws the same of other vertices. */
static enum polygon_result draw(const struct frame *frame, const struct vertex *vertices,
                                const uint32 *colours, int32 count,
                                const struct material *material, const struct drawing *drawing,
                                polygon_routine *routine)
{
    struct tx_unit *unit = material->unit;
    enum tx_result check;
    enum polygon_result result;
    struct tx_needs needs;
    struct setup s;
    struct material plain;
    struct drawing whole;

    if (count < 3 || count > POLYGON_VERTICES_MAX)
        return POLYGON_FEW;
    if (frame->pixel_bytes == 1)
        return POLYGON_WRONG_MAP;
    check = judge(unit, vertices, count);
    if (check != TX_DONE)
        return tx_refused(unit, check);
    setup_begin(&s, frame, vertices, count, material, drawing);
    if (count > 3 && drawing->planar != PLANAR_ALL
        && !planar_is(drawing, vertices, vertices, count, planes_asked(&unit->tx, colours)))
        return polygon_fan(routine, frame, vertices, count, material, drawing);
    tx_lower_inputs(&needs, &s, &unit->tx, colours);
    if (tx_lower_to_flat(&needs, &s))
        result = draw_flat(&s, constant_colour(&unit->tx, &needs.shade), drawing);
    else if (tx_lower_to_plain(&needs, &s, unit, &plain, &vertices))
        result = polygon_draw(frame, vertices, count, &plain,
                              planar_vouched(&whole, drawing, PLANAR_ALL));
    else
        result = draw_planes(&s, unit, &needs, colours);
    if (result == POLYGON_DRAWN)
        tx_drawn(&unit->tx);
    return result;
}

enum polygon_result tx_polygon_copy(const struct frame *frame, const struct vertex *vertices,
                                    int32 count, const struct material *material,
                                    const struct drawing *drawing)
{
    return draw(frame, vertices, 0, count, material, drawing, tx_polygon_copy);
}

enum polygon_result tx_polygon_draw(const struct frame *frame, const struct vertex *vertices,
                                    int32 count, const struct material *material,
                                    const struct drawing *drawing)
{
    if (material->unit->tx.modes.cycle == TX_COPY)
        return tx_refused(material->unit, TX_CYCLE_TYPE);
    return draw(frame, vertices, 0, count, material, drawing, tx_polygon_draw);
}

enum polygon_result tx_polygon_draw_coloured(const struct frame *frame,
                                             const struct vertex *vertices, int32 count,
                                             const struct material *material,
                                             const struct drawing *drawing)
{
    static uint32 colours[POLYGON_VERTICES_MAX];

    if (material->unit->tx.modes.cycle == TX_COPY)
        return tx_refused(material->unit, TX_CYCLE_TYPE);
    for (int32 i = 0; i < count && i < POLYGON_VERTICES_MAX; i++)
        colours[i] = (uint32)vertices[i].shade;
    return draw(frame, vertices, colours, count, material, drawing, tx_polygon_draw_coloured);
}

void tx_unit_init(struct tx_unit *unit, const uint8 *dram, uint32 dram_bytes, int32 memory)
{
    static const struct tx_kept none;

    tx_init(&unit->tx, dram, dram_bytes);
    unit->result = TX_DONE;
    unit->memory = memory;
    unit->judged = 0;
    unit->levels = 0;
    unit->tables = 0;
    unit->yuv = 0;
    unit->levels_made = unit->tables_made = unit->yuv_made = 0;
    page_init(&unit->page.page);
    for (int32 i = 0; i < TX_PAGE_KEY; i++)
        unit->page.key[i] = 0;
    for (int32 i = 0; i < TX_TILES; i++)
        unit->tiles[i] = unit->chroma[i] = none;
}
