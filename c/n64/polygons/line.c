/* Draws a line of a polygon, pass by pass. */
#include "n64/polygons/plan.h"

/* A run of pixels with the same tiles. */
struct run {
    int32 first, count, tile0, tile1;
};

/* Coordinates relative to a tile. */
static const uint32 *relate(struct n64_line_scratch *work, const struct n64_sampling *from,
                            const uint32 *at, int32 count)
{
    if (!from->relative)
        return at;
    from->relative(at, work->relative, &from->axes, count);
    return work->relative;
}

static void sample(struct n64_line_scratch *work, const struct n64_sampling *from,
                   const uint32 *at, uint32 *texels, int32 count)
{
    from->sample(relate(work, from, at, count), texels, from->tile, count);
}

static void sample_yuv(struct n64_line_scratch *work, const struct n64_sampling *from,
                       const uint32 *at, uint32 *luma, uint32 *chroma, int32 count)
{
    at = relate(work, from, at, count);
    from->sample(at, luma, from->tile, count);
    if (!from->chroma)
        return;
    n64_chroma(at, work->relative, 0, count);
    from->sample(work->relative, chroma, from->chroma, count);
}

static const int16 *fractions_of(const struct n64_plan *plan, int32 first)
{
    return plan->form.fraction < 0 ? &plan->scratch->line.blendings[first].fraction
                                   : &plan->form.fraction;
}

/* Finds a run's texels, blended if the form blends. A blend of a tile with itself is skipped. */
static void sample_run(const struct n64_plan *plan, const struct run *run, uint32 *texels)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    const struct n64_form *form = &plan->form;
    const uint32 *at = work->coordinates + run->first;
    uint32 *other = work->texels1 + run->first;
    struct n64_blend blend;

    texels += run->first;
    sample(work, &plan->tiles[form->swapped ? run->tile1 : run->tile0], at, texels, run->count);
    if (!plan->second_texel || (form->first == N64_FIRST_BLEND && run->tile0 == run->tile1))
        return;
    sample(work, &plan->tiles[form->swapped ? run->tile0 : run->tile1], at, other, run->count);
    if (form->first != N64_FIRST_BLEND)
        return;
    blend.other = other;
    blend.fractions = fractions_of(plan, run->first);
    blend.fraction_step = form->fraction < 0 ? (int32)sizeof *work->blendings : 0;
    n64_lerp(texels, texels, &blend, run->count);
}

/* Finds how many pixels from run->first on have the same tiles, and which. */
static void find_run(const struct n64_plan *plan, struct run *run, int32 end)
{
    const struct n64_blending *from = &plan->scratch->line.blendings[run->first];

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

static void find_texels(const struct n64_plan *plan, uint32 *texels, int32 count)
{
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        find_run(plan, &run, count);
        sample_run(plan, &run, texels);
    }
}

static void find_yuv(const struct n64_plan *plan, int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        find_run(plan, &run, count);
        for (int32 i = 0; i < 2; i++)
            if (plan->yuv.sampled[i])
                sample_yuv(work, &plan->tiles[i ? run.tile1 : run.tile0],
                           work->coordinates + run.first, work->yuv[i].luma + run.first,
                           work->yuv[i].chroma + run.first, run.count);
    }
}

/* Draws texels directly as 16-bit pixels. */
static void draw_direct(const struct n64_plan *plan, uint16 *pixels, int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        const struct n64_sampling *from;

        find_run(plan, &run, count);
        from = &plan->tiles[plan->form.swapped ? run.tile1 : run.tile0];
        n64_threepoint_16(relate(work, from, work->coordinates + run.first, run.count),
                          pixels + run.first, from->tile, run.count);
    }
}

static void find_shades(const struct n64_plan *plan, int32 x, int32 y, int32 count)
{
    const struct n64_planes *planes = plan->planes;
    const struct plane *of = planes->all.of;
    struct n64_shades start, steps;

    for (int32 i = 0; i < 4; i++) {
        (&start.r)[i] = (int32)planes_at(&planes->all, N64_RED + i, x, y);
        (&steps.r)[i] = (int32)of[N64_RED + i].dx;
    }
    n64_shade(&start, plan->scratch->line.shades, &steps, count);
}

static void modulate(const struct n64_plan *plan, const uint32 *texels, uint32 *colours,
                     int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    struct n64_modulation by;

    by.other = plan->planes->shaded ? work->shades : &plan->shade;
    by.step = plan->planes->shaded ? (int32)sizeof *work->shades : 0;
    n64_modulate(texels, colours, &by, count);
}

static void combine(const struct n64_plan *plan, const uint32 *texels, uint32 *colours,
                    int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    struct n64_wide (*wide)[N64_LINE_PIXELS] = work->wide;
    struct n64_places places;
    int32 has_second = plan->second_texel;

    if (plan->yuv.on) {
        has_second = plan->yuv.needed[1];
        for (int32 i = 0; i < 2; i++)
            if (plan->yuv.needed[i])
                n64_yuv_widen(plan, work->yuv, i, wide[i], count);
    } else {
        n64_widen(texels, wide[0], 0, count);
        if (has_second)
            n64_widen(work->texels1, wide[1], 0, count);
    }
    if (plan->planes->shaded)
        n64_widen(work->shades, wide[2], 0, count);
    else
        n64_widen(&plan->shade, wide[2], 0, 1);
    places.texel0 = wide[0];
    places.texel1 = wide[has_second];
    places.shade = wide[2];
    places.shade_step = plan->planes->shaded ? (int32)sizeof **wide : 0;
    places.fraction = &work->blendings->fraction;
    places.fraction_step = sizeof *work->blendings;
    n64_combine_line(&plan->unit->n64, &places, work->results, colours, count);
}

static void find_coordinates(const struct n64_plan *plan, int32 x, int32 y, int32 count)
{
    const struct n64_planes *planes = plan->planes;
    struct n64_iterators at;

    at.s = (int32)planes_at(&planes->all, N64_S, x, y);
    at.t = (int32)planes_at(&planes->all, N64_T, x, y);
    at.w = (int32)planes_at(&planes->all, N64_W, x, y);
    plan->coordinates(&at, plan->scratch->line.coordinates, &plan->steps, count);
}

static void draw_part(const struct n64_plan *plan, const struct frame *frame, int32 x, int32 y,
                      int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    uint8 *pixels = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    uint32 *colours = frame->pixel_bytes == 4 ? (uint32 *)pixels : work->colours;
    int32 second = plan->form.any || plan->form.second != N64_SECOND_NOTHING;
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
        find_shades(plan, x, y, count);
    if (plan->form.any)
        combine(plan, texels, colours, count);
    else if (plan->yuv.on)
        n64_yuv_colours(plan, work->yuv, colours, count);
    else if (plan->form.second == N64_SECOND_MODULATE)
        modulate(plan, texels, colours, count);
    else if (plan->form.second == N64_SECOND_TABLES)
        n64_map(texels, colours, plan->tables, count);
    if (frame->pixel_bytes == 2)
        n64_store_16(colours, pixels, 0, count);
}

void n64_plan_draw(const struct n64_plan *plan, const struct frame *frame, int32 x, int32 y,
                   int32 count)
{
    do {
        const int32 part = count < N64_LINE_PIXELS ? count : N64_LINE_PIXELS;

        draw_part(plan, frame, x, y, part);
        x += part;
        count -= part;
    } while (count > 0);
}
