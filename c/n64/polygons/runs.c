/* Samples a line whose levels change tiles from run to run of pixels, for what has no pass in
   assembly. */
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

static void multiply(const uint32 *other, uint32 *texels, int32 count)
{
    struct n64_modulation by;

    by.other = other;
    by.step = sizeof *other;
    n64_modulate(texels, texels, &by, count);
}

/* Finds a run's texels, blended or multiplied as the form says. A blend of a tile with itself is skipped. */
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
    if (form->first == N64_FIRST_PRODUCT)
        multiply(other, texels, run->count);
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

    run->tile0 = from->tile0;
    run->tile1 = from->tile1;
    run->count = 1;
    while (run->first + run->count < end && from[run->count].tile0 == from->tile0
           && from[run->count].tile1 == from->tile1)
        run->count++;
}

void n64_runs_texels(const struct n64_plan *plan, void *texels, int32 count)
{
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        find_run(plan, &run, count);
        sample_run(plan, &run, texels);
    }
}

void n64_runs_yuv(const struct n64_plan *plan, void *lines, int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    struct n64_yuv_line *to = lines;
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        find_run(plan, &run, count);
        for (int32 i = 0; i < 2; i++)
            if (plan->yuv.sampled[i])
                sample_yuv(work, &plan->tiles[i ? run.tile1 : run.tile0],
                           work->coordinates + run.first, to[i].luma + run.first,
                           to[i].chroma + run.first, run.count);
    }
}

/* Draws texels directly as 16-bit pixels. */
void n64_runs_direct(const struct n64_plan *plan, void *pixels, int32 count)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    struct run run;

    for (run.first = 0; run.first < count; run.first += run.count) {
        const struct n64_sampling *from;

        find_run(plan, &run, count);
        from = &plan->tiles[plan->form.swapped ? run.tile1 : run.tile0];
        n64_threepoint_16(relate(work, from, work->coordinates + run.first, run.count),
                          (uint16 *)pixels + run.first, from->tile, run.count);
    }
}
