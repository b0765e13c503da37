/* A line of a polygon, pass by pass. */
#include "polygon/line_room.h"
#include "tx/pixels.h"
#include "tx/plan.h"

/* What stands between the passes of a line, so many pixels at a time. */
struct work {
    uint32 coordinates[TX_LINE_PIXELS], relative[TX_LINE_PIXELS];
    struct tx_blending blendings[TX_LINE_PIXELS];
    uint32 texels0[TX_LINE_PIXELS], texels1[TX_LINE_PIXELS];
    uint32 shades[TX_LINE_PIXELS], colours[TX_LINE_PIXELS];
    struct tx_yuv_line yuv[2];
    struct tx_wide wide[3][TX_LINE_PIXELS];     /* texel 0, texel 1, shade */
    struct tx_wide results[2][TX_LINE_PIXELS];  /* of both cycles */
};

static struct work *const work = (struct work *)line_room;
extern char work_fits[sizeof(struct work) <= LINE_ROOM ? 1 : -1];

struct tx_blending *tx_line_blendings(void)
{
    return work->blendings;
}

/* A run of pixels of the same tiles. */
struct run {
    int32 first, count, tile0, tile1;
};

/* Coordinates relative to a tile. */
static const uint32 *relate(const struct tx_sampling *from, const uint32 *at, int32 count)
{
    if (!from->relative)
        return at;
    from->relative(at, work->relative, &from->axes, count);
    return work->relative;
}

static void sample(const struct tx_sampling *from, const uint32 *at, uint32 *texels, int32 count)
{
    from->sample(relate(from, at, count), texels, from->tile, count);
}

static void sample_yuv(const struct tx_sampling *from, const uint32 *at, uint32 *luma,
                       uint32 *chroma, int32 count)
{
    at = relate(from, at, count);
    from->sample(at, luma, from->tile, count);
    if (!from->chroma)
        return;
    tx_chroma(at, work->relative, 0, count);
    from->sample(work->relative, chroma, from->chroma, count);
}

static const int16 *fractions_of(const struct tx_plan *plan, int32 first)
{
    return plan->form.fraction < 0 ? &work->blendings[first].fraction : &plan->form.fraction;
}

/* Texels of one tile; where the blend is of that and itself it is left out. */
static void sample_run(const struct tx_plan *plan, const struct run *run, uint32 *texels)
{
    const struct tx_form *form = &plan->form;
    const uint32 *at = work->coordinates + run->first;
    uint32 *other = work->texels1 + run->first;
    struct tx_blend blend;

    texels += run->first;
    sample(&plan->tiles[form->swapped ? run->tile1 : run->tile0], at, texels, run->count);
    if (!plan->second_texel || (form->first == TX_FIRST_BLEND && run->tile0 == run->tile1))
        return;
    sample(&plan->tiles[form->swapped ? run->tile0 : run->tile1], at, other, run->count);
    if (form->first != TX_FIRST_BLEND)
        return;
    blend.other = other;
    blend.fractions = fractions_of(plan, run->first);
    blend.fraction_step = form->fraction < 0 ? (int32)sizeof *work->blendings : 0;
    tx_lerp(texels, texels, &blend, run->count);
}

/* The next pixels that have the same tiles. */
static void find_run(const struct tx_plan *plan, struct run *run, int32 end)
{
    const struct tx_blending *from = &work->blendings[run->first];

    run->count = end - run->first;
    run->tile0 = plan->tile0;
    run->tile1 = plan->tile1;
    if (!plan->levels)
        return;
    run->tile0 = from->tile0;
    run->tile1 = from->tile1;
    run->count = 1;
    while (run->first + run->count < end && from[run->count].tile0 == from->tile0
           && from[run->count].tile1 == from->tile1)
        run->count++;
}

static void find_texels(const struct tx_plan *plan, uint32 *texels, int32 count)
{
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        find_run(plan, &run, count);
        sample_run(plan, &run, texels);
    }
}

static void find_yuv(const struct tx_plan *plan, int32 count)
{
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        find_run(plan, &run, count);
        for (int32 i = 0; i < 2; i++)
            if (plan->yuv.sampled[i])
                sample_yuv(&plan->tiles[i ? run.tile1 : run.tile0], work->coordinates + run.first,
                           work->yuv[i].luma + run.first, work->yuv[i].chroma + run.first, run.count);
    }
}

/* Texels that are pixels. */
static void draw_direct(const struct tx_plan *plan, uint16 *pixels, int32 count)
{
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        const struct tx_sampling *from;

        find_run(plan, &run, count);
        from = &plan->tiles[plan->form.swapped ? run.tile1 : run.tile0];
        tx_threepoint_16(relate(from, work->coordinates + run.first, run.count), pixels + run.first,
                         from->tile, run.count);
    }
}

static void find_shades(const struct tx_planes *planes, int32 x, int32 y, int32 count)
{
    const struct plane *of = planes->all.of;
    struct tx_shades start, steps;

    start.r = (int32)tx_plane_at(planes, TX_RED, x, y);
    start.g = (int32)tx_plane_at(planes, TX_GREEN, x, y);
    start.b = (int32)tx_plane_at(planes, TX_BLUE, x, y);
    start.a = (int32)tx_plane_at(planes, TX_ALPHA, x, y);
    steps.r = (int32)of[TX_RED].dx;
    steps.g = (int32)of[TX_GREEN].dx;
    steps.b = (int32)of[TX_BLUE].dx;
    steps.a = (int32)of[TX_ALPHA].dx;
    tx_shade(&start, work->shades, &steps, count);
}

static void modulate(const struct tx_plan *plan, const uint32 *texels, uint32 *colours,
                     int32 count)
{
    struct tx_modulation by;

    by.other = plan->planes->shaded ? work->shades : &plan->shade;
    by.step = plan->planes->shaded ? (int32)sizeof *work->shades : 0;
    tx_modulate(texels, colours, &by, count);
}

/* The combiner's cycles as they stand. */
static void combine(const struct tx_plan *plan, const uint32 *texels, uint32 *colours,
                    int32 count)
{
    struct tx_wide (*wide)[TX_LINE_PIXELS] = work->wide;
    struct tx_places places;
    int32 has_second = plan->second_texel;

    if (plan->yuv.on) {
        has_second = plan->yuv.needed[1];
        for (int32 i = 0; i < 2; i++)
            if (plan->yuv.needed[i])
                tx_yuv_widen(plan, work->yuv, i, wide[i], count);
    } else {
        tx_widen(texels, wide[0], 0, count);
        if (has_second)
            tx_widen(work->texels1, wide[1], 0, count);
    }
    if (plan->planes->shaded)
        tx_widen(work->shades, wide[2], 0, count);
    else
        tx_widen(&plan->shade, wide[2], 0, 1);
    places.texel0 = wide[0];
    places.texel1 = wide[has_second];
    places.shade = wide[2];
    places.shade_step = plan->planes->shaded ? (int32)sizeof **wide : 0;
    places.fraction = &work->blendings->fraction;
    places.fraction_step = sizeof *work->blendings;
    tx_combine_line(&plan->unit->tx, &places, work->results, colours, count);
}

static void find_coordinates(const struct tx_plan *plan, int32 x, int32 y, int32 count)
{
    const struct tx_planes *planes = plan->planes;
    struct tx_iterators at;

    at.s = (int32)tx_plane_at(planes, TX_S, x, y);
    at.t = (int32)tx_plane_at(planes, TX_T, x, y);
    at.w = (int32)tx_plane_at(planes, TX_W, x, y);
    plan->coordinates(&at, work->coordinates, &plan->steps, count);
}

static void draw_part(const struct tx_plan *plan, const struct frame *frame, int32 x, int32 y,
                      int32 count)
{
    uint8 *pixels = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    uint32 *colours = frame->pixel_bytes == 4 ? (uint32 *)pixels : work->colours;
    int32 second = plan->form.any || plan->form.second != TX_SECOND_NOTHING;
    uint32 *texels = second ? work->texels0 : colours;

    find_coordinates(plan, x, y, count);
    if (frame->pixel_bytes == 2 && plan->is_direct) {
        draw_direct(plan, (uint16 *)pixels, count);
        return;
    }
    if (plan->yuv.on)
        find_yuv(plan, count);
    else
        find_texels(plan, texels, count);
    if (plan->planes->shaded)
        find_shades(plan->planes, x, y, count);
    if (plan->form.any)
        combine(plan, texels, colours, count);
    else if (plan->yuv.on)
        tx_yuv_colours(plan, work->yuv, colours, count);
    else if (plan->form.second == TX_SECOND_MODULATE)
        modulate(plan, texels, colours, count);
    else if (plan->form.second == TX_SECOND_TABLES)
        tx_map(texels, colours, plan->tables, count);
    if (frame->pixel_bytes == 2)
        tx_store_16(colours, pixels, 0, count);
}

void tx_plan_draw(const struct tx_plan *plan, const struct frame *frame, int32 x, int32 y,
                  int32 count)
{
    do {
        const int32 part = count < TX_LINE_PIXELS ? count : TX_LINE_PIXELS;

        draw_part(plan, frame, x, y, part);
        x += part;
        count -= part;
    } while (count > 0);
}
