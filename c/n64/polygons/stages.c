/* Lists the passes that draw a polygon's lines, in order. */
#include "n64/polygons/plan.h"
#include "n64/codes.h"

struct list {
    struct n64_plan *plan;
    struct n64_line_scratch *work;
    struct n64_stage *next;
};

/* Adds a pass. in, out: null for the line's pixels. */
static void add(struct list *list, n64_pass *pass, const void *in, void *out,
                const void *constants)
{
    struct n64_stage *stage = list->next++;

    stage->in = in;
    stage->out = out;
    stage->constants = constants;
    stage->pass = pass;
}

static void add_runs(struct list *list, n64_runs *routine, void *out)
{
    list->plan->in_c.routine = routine;
    list->plan->in_c.plan = list->plan;
    list->plan->stages.joins = 0;
    add(list, n64_in_c, 0, out, &list->plan->in_c);
}

/* Adds the pass to coordinates relative to a tile, if it needs one. is_last: no other tile's are made of them. Returns
   where they are. */
static const uint32 *relate(struct list *list, const struct n64_sampling *from, int32 is_last)
{
    const struct n64_axis_range *s = &from->axes.s, *t = &from->axes.t;
    const int32 is_line = list->plan->coordinates == n64_walk && !s->shift && !t->shift && (s->clamp || t->clamp);
    uint32 *to = is_last ? list->work->coordinates : list->work->relative;

    if (!from->relative)
        return list->work->coordinates;
    if (is_line)
        list->plan->walked[list->plan->walked_count++] = list->next;
    add(list, from->relative, list->work->coordinates, to, &from->axes);
    return to;
}

static void sample(struct list *list, int32 tile, uint32 *texels, int32 is_last)
{
    const struct n64_sampling *from = &list->plan->tiles[tile];
    const uint32 *at = relate(list, from, is_last);

    add(list, list->plan->is_intensity && from->sample == n64_threepoint ? n64_threepoint_intensity
              : from->sample, at, texels, from->tile);
}

/* Adds the blend of both texels. */
static void blend(struct list *list, uint32 *texels, const int16 *fractions, int32 step)
{
    struct n64_blend *of = &list->plan->blend;

    of->other = list->work->texels1;
    of->fractions = fractions;
    of->fraction_step = step;
    add(list, n64_lerp, list->work->texels0, texels, of);
}

/* Adds the form's first part: the texel, both texels, their blend or their product. */
static void find_texels(struct list *list, uint32 *texels)
{
    struct n64_plan *plan = list->plan;
    const struct n64_form *form = &plan->form;

    uint32 *first = form->first != N64_FIRST_TEXEL ? list->work->texels0 : texels;

    sample(list, form->swapped ? plan->tile1 : plan->tile0, first, !plan->second_texel);
    if (!plan->second_texel)
        return;
    sample(list, form->swapped ? plan->tile0 : plan->tile1, list->work->texels1, 1);
    if (form->first == N64_FIRST_BLEND) {
        blend(list, texels, &form->fraction, 0);
    } else if (form->first == N64_FIRST_PRODUCT && !plan->is_intensity) {
        plan->product.other = list->work->texels1;
        plan->product.step = sizeof *list->work->texels1;
        add(list, n64_modulate, first, texels, &plan->product);
    }
}

static int32 has_level_tiles(const struct n64_plan *plan)
{
    const uint32 used = n64_tiles_used(&plan->unit->n64);

    for (int32 n = 0; n < N64_TILES; n++)
        if (used >> n & 1 && (plan->tiles[n].sample != n64_threepoint || plan->tiles[n].shift < 0))
            return 0;
    return plan->only_blends;
}

/* Adds a blend of levels, each texel of a line by one pass over all its tiles. */
static void find_levels(struct list *list, uint32 *texels)
{
    struct n64_plan *plan = list->plan;
    const uint32 used = n64_tiles_used(&plan->unit->n64);
    const struct n64_quad *const quads = plan->tiles[plan->tile0].tile->quads;

    for (int32 n = 0; n < N64_TILES; n++) {
        const struct n64_sampling *from = &plan->tiles[n];
        struct n64_level_tile *to = &plan->level_tiles[n];

        if (!(used >> n & 1))
            continue;
        to->mask_s = from->tile->mask_s;
        to->mask_t = from->tile->mask_t;
        to->fractions = from->fractions;
        to->quads_at = (uint32)from->tile->quads - (uint32)quads;
        to->columns_bits = from->tile->columns_bits;
        to->shift = (uint16)from->shift;
    }
    for (int32 i = 0; i < 2; i++) {
        struct n64_level_sampling *sampling = &plan->level_samplings[i];

        sampling->blendings = list->work->blendings;
        sampling->tiles = plan->level_tiles;
        sampling->quads = quads;
        sampling->second = (int16)(i != plan->form.swapped);
        sampling->skips = (int16)i;
        add(list, n64_threepoint_levels, list->work->coordinates,
            i ? list->work->texels1 : list->work->texels0, sampling);
    }
    blend(list, texels, &list->work->blendings->fraction, sizeof *list->work->blendings);
}

/* The tile of the form's one texel if a pass samples and converts it, else null. */
static const struct n64_sampling *yuv_filtered(const struct n64_plan *plan)
{
    const struct n64_sampling *from = &plan->tiles[plan->yuv.tile[plan->form.swapped] ? plan->tile1 : plan->tile0];

    return plan->form.any || plan->levels || !from->chroma || from->sample != n64_threepoint ? 0 : from;
}

static void find_yuv(struct list *list)
{
    struct n64_plan *plan = list->plan;

    if (yuv_filtered(plan))
        return;
    for (int32 i = 0; i < 2; i++) {
        const struct n64_sampling *from = &plan->tiles[i ? plan->tile1 : plan->tile0];
        struct n64_yuv_line *to = &list->work->yuv[i];
        const uint32 *at;

        if (!plan->yuv.sampled[i])
            continue;
        at = relate(list, from, i || !plan->yuv.sampled[1]);
        add(list, from->sample, at, to->luma, from->tile);
        if (!from->chroma)
            continue;
        add(list, n64_chroma, at, list->work->relative, 0);
        add(list, from->sample, list->work->relative, to->chroma, from->chroma);
    }
}

/* Adds the conversion of the form's one texel to colours, from its samples or together with them. */
static void convert(struct list *list, uint32 *colours)
{
    struct n64_plan *plan = list->plan;
    const struct n64_sampling *from = yuv_filtered(plan);
    struct n64_yuv_conversion *by = &plan->conversions[0];
    struct n64_yuv_filter *to = &plan->yuv_filter;

    if (!from) {
        const uint32 *luma = n64_yuv_conversion_set(by, plan, list->work->yuv, plan->form.swapped);

        add(list, n64_convert, luma, colours, by);
        return;
    }
    to->luma = from->tile->quads;
    to->chroma = from->chroma->quads;
    to->mask_s = from->tile->mask_s;
    to->mask_t = from->tile->mask_t;
    to->columns_bits = from->tile->columns_bits;
    to->matrix = plan->yuv.conversion.matrix;
    to->colours = plan->yuv.conversion.colours;
    add(list, n64_threepoint_yuv, relate(list, from, 1), colours, to);
}

/* Adds what makes inputs of the combiner. Returns non-zero if there is a texel 1. */
static int32 widen(struct list *list, const uint32 *texels)
{
    struct n64_plan *plan = list->plan;
    struct n64_line_scratch *work = list->work;

    if (plan->shaded)
        add(list, n64_widen, work->shades, work->wide[2], 0);
    else
        n64_widen(&plan->shade, &plan->combiner.shade, 0, 1);
    if (!plan->yuv.on) {
        add(list, n64_widen, texels, work->wide[0], 0);
        if (plan->second_texel)
            add(list, n64_widen, work->texels1, work->wide[1], 0);
        return plan->second_texel;
    }
    for (int32 i = 0; i < 2; i++) {
        struct n64_yuv_conversion *by = &plan->conversions[i];
        const uint32 *luma;

        if (!plan->yuv.needed[i])
            continue;
        luma = n64_yuv_conversion_set(by, plan, work->yuv, i);
        add(list, plan->yuv.converted[i] ? n64_convert_wide : n64_widen_yuv, luma, work->wide[i],
            by);
    }
    return plan->yuv.needed[1];
}

static void find_cycle(struct list *list, const struct n64_places *places, int32 cycle)
{
    struct n64_combiner_plan *plan = &list->plan->combiner;

    n64_combiner_find(plan, &list->plan->unit->n64, places, cycle);
    for (int32 i = 0; i < 4; i++)
        add(list, n64_combiner, 0, &list->work->results[cycle]->channels[i], &plan->of[cycle][i]);
}

/* Adds the combiner's cycles, except one that only hands on texel 0 or the result before it. */
static void combine(struct list *list, const uint32 *texels, uint32 *colours)
{
    struct n64_plan *plan = list->plan;
    const struct n64 *n64 = &plan->unit->n64;
    struct n64_line_scratch *work = list->work;
    const int32 is_two = n64->modes.cycle == N64_TWO_CYCLES;
    const int32 is_last = is_two && n64_form_is_input(n64, 1, N64_COMBINED);
    struct n64_places places;

    places.texel0 = work->wide[0];
    places.texel1 = work->wide[widen(list, texels)];
    places.shade = plan->shaded ? work->wide[2] : &plan->combiner.shade;
    places.shade_step = plan->shaded ? (int32)sizeof *places.shade : 0;
    places.fraction = &work->blendings->fraction;
    places.fraction_step = sizeof *work->blendings;
    places.combined = work->results[0];
    n64_combiner_begin(&plan->combiner, n64);
    if (is_two && !is_last && n64_form_is_input(n64, 0, N64_TEXEL0))
        places.combined = places.texel0;
    else if (is_two)
        find_cycle(list, &places, 0);
    if (!is_last)
        find_cycle(list, &places, 1);
    add(list, n64_narrow, work->results[!is_last], colours, 0);
}

static void modulate(struct list *list, const uint32 *texels, uint32 *colours)
{
    struct n64_plan *plan = list->plan;

    plan->modulation.other = plan->shaded ? list->work->shades : &plan->shade;
    plan->modulation.step = plan->shaded ? (int32)sizeof *list->work->shades : 0;
    add(list, n64_modulate, texels, colours, &plan->modulation);
}

/* Returns non-zero if a tile's texels have one value for all channels. */
static int32 has_intensities(const struct n64 *n64, int32 n)
{
    return n64->tiles[n].format >= N64_I && n64->tiles[n].size <= N64_8 && !n64->modes.tlut;
}

/* Finds whether one channel is enough until tables make colours of it. */
static int32 is_intensity(const struct n64_plan *plan)
{
    const struct n64 *n64 = &plan->unit->n64;
    const struct n64_form *form = &plan->form;

    return form->second == N64_SECOND_TABLES && form->first != N64_FIRST_BLEND && !form->any && !plan->levels
        && !plan->yuv.on && has_intensities(n64, form->swapped ? plan->tile1 : plan->tile0)
        && (!plan->second_texel || has_intensities(n64, form->swapped ? plan->tile0 : plan->tile1));
}

/* Adds the tables of intensities, or of the products of two. */
static void colour(struct list *list, const uint32 *intensities, uint32 *colours)
{
    struct n64_plan *plan = list->plan;

    if (!plan->second_texel) {
        add(list, n64_map_intensity, intensities, colours, plan->tables);
        return;
    }
    plan->intensities.other = list->work->texels1;
    plan->intensities.colours = plan->tables;
    add(list, n64_modulate_intensity, intensities, colours, &plan->intensities);
}

/* Adds what the texels are made of. */
static void find_first(struct list *list, uint32 *texels, int32 pixel_bytes)
{
    struct n64_plan *plan = list->plan;
    const struct n64_sampling *from = &plan->tiles[plan->form.swapped ? plan->tile1 : plan->tile0];
    const int32 is_direct = pixel_bytes == 2 && plan->is_direct;

    if (plan->levels && has_level_tiles(plan)) {
        find_levels(list, texels);
    } else if (plan->levels) {
        if (plan->yuv.on)
            add_runs(list, n64_runs_yuv, list->work->yuv);
        else
            add_runs(list, is_direct ? n64_runs_direct : n64_runs_texels, texels);
    } else if (is_direct) {
        const uint32 *at = relate(list, from, 1);

        add(list, n64_threepoint_16, at, 0, from->tile);
    } else if (plan->yuv.on) {
        find_yuv(list);
    } else {
        find_texels(list, texels);
    }
}

/* Adds what makes colours of the texels. */
static void find_second(struct list *list, const uint32 *texels, uint32 *colours)
{
    const struct n64_plan *plan = list->plan;

    if (plan->form.any)
        combine(list, texels, colours);
    else if (plan->yuv.on)
        convert(list, colours);
    else if (plan->form.second == N64_SECOND_MODULATE)
        modulate(list, texels, colours);
    else if (plan->is_intensity)
        colour(list, texels, colours);
    else if (plan->form.second == N64_SECOND_TABLES)
        add(list, n64_map, texels, colours, plan->tables);
}

void n64_stages_find(struct n64_plan *plan, int32 pixel_bytes)
{
    struct n64_line_scratch *work = &plan->scratch->line;
    const struct n64_form *form = &plan->form;
    const int32 is_direct = pixel_bytes == 2 && plan->is_direct;
    const int32 is_one = !form->any && form->second == N64_SECOND_NOTHING && !plan->yuv.on;
    uint32 *colours = pixel_bytes == 4 ? 0 : work->colours;
    uint32 *texels = is_one ? colours : work->texels0;
    struct n64_stages *stages = &plan->stages;
    struct list list;

    list.plan = plan;
    list.work = work;
    list.next = stages->of;
    plan->is_intensity = is_intensity(plan);
    plan->walked_count = 0;
    stages->last_interpolant = plan->shaded ? N64_ALPHA : plan->coordinates == n64_walk ? N64_T : N64_W;
    stages->joins = !plan->levels;
    stages->pixel_bits = pixel_bytes / 2;
    add(&list, plan->coordinates, &stages->at[N64_S], work->coordinates, &plan->steps);
    if (plan->shaded && !is_direct)
        add(&list, n64_shade, &stages->at[N64_RED], work->shades, &plan->shade_steps);
    stages->by_line = (uint16)(list.next - stages->of);
    find_first(&list, is_direct ? 0 : texels, pixel_bytes);
    if (!is_direct) {
        find_second(&list, texels, colours);
        if (pixel_bytes == 2)
            add(&list, n64_store_16, colours, 0, 0);
    }
    stages->last_stage = (uint16)(list.next - stages->of - 1);
}

void n64_plan_draw(struct n64_plan *plan, const struct frame *frame, const struct scanline *lines,
                   int32 y, int32 rows, int32 width)
{
    struct n64_stages *stages = &plan->stages;
    const int32 is_together = stages->joins && width <= N64_TOGETHER && width * rows <= N64_LINE_PIXELS;

    for (int32 i = 0; i <= stages->last_interpolant; i++)
        stages->starts[i] = planes_at(&plan->planes->all, i, stages->column, y);
    stages->pixels = frame->pixels + y * frame->pitch;
    stages->pitch = frame->pitch;
    for (int32 i = 0; i < plan->walked_count; i++)
        plan->walked[i]->pass = is_together ? n64_tile : n64_tile_walked;
    if (is_together)
        n64_stages_together(stages, lines, rows, plan->scratch->line.pixels);
    else
        n64_stages_draw(stages, lines, rows);
}
