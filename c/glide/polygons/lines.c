/* Finds the passes of a polygon all of whose lines have the same ones. */
#include "glide/polygons/plan.h"

void glide_lines_stage(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                       const void *constants)
{
    struct glide_stage *stage = &lines->stages[lines->last_stage];

    if (lines->last_stage == GLIDE_STAGES) {
        lines->is_full = 1;
        return;
    }
    stage->in = in;
    stage->out = out;
    stage->constants = constants;
    stage->pass = pass;
    lines->last_stage++;
}

void glide_lines_add(struct glide_lines *lines, glide_pass *pass, const void *in, void *out,
                     const void *constants, uint32 bytes)
{
    uint32 *to = lines->constants + lines->longs;
    const uint32 *from = constants;

    if (lines->longs + bytes / 4 > GLIDE_STAGE_LONGS) {
        lines->is_full = 1;
        return;
    }
    for (uint32 n = bytes / 4; n; n--)
        *to++ = *from++;
    glide_lines_stage(lines, pass, in, out, lines->constants + lines->longs);
    lines->longs += bytes / 4;
}

static void set_points(struct glide_points *to, const struct planes *planes, int32 first, int32 y)
{
    const struct plane *of = &planes->of[first];
    const uint32 right = (uint32)(-EDGE_BIAS - planes->i), down = (uint32)(y - planes->j);
    int32 *start = &to->start.s;

    to->deep = (int32)(of[GLIDE_W].dx | of[GLIDE_W].dy);
    to->at.w = to->start.w = (int32)of[GLIDE_W].at;
    to->across.w = to->down.w = 0;
    for (int32 n = to->deep ? 3 : 2; n; n--, start++, of++) {
        start[0] = (int32)(of->at + right * of->dx + down * of->dy);
        start[GLIDE_ACROSS] = (int32)of->dx;
        start[GLIDE_DOWN] = (int32)of->dy;
    }
}

/* Whether all lines of the unit have the same passes, all of them in assembly. */
static int32 is_steady(struct glide_part *part)
{
    const struct glide_sampling *from = &part->samplings[part->band];
    const uint32 bits = part->bands->of[part->band].bits;

    if (!part->is_one
        || (part->glide->modes.dither && bits & (GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER)))
        return 0;
    if (!(bits & GLIDE_NEEDS_OWN))
        return 1;
    return (from->level || glide_sampling_find(part, part->band))
        && from->sample != glide_filter_line && from->sample != glide_filter_line_8;
}

static int32 has_coordinates(const struct glide_part *part, const struct glide_part *before)
{
    const struct glide_steps *a, *b;

    if (!before || !(before->bands->of[before->band].bits & GLIDE_NEEDS_OWN)
        || before->first != part->first || before->coordinates != part->coordinates
        || before->piece_bits != part->piece_bits)
        return 0;
    a = &part->samplings[part->band].steps;
    b = &before->samplings[before->band].steps;
    return a->shift == b->shift && a->half == b->half && a->last_s == b->last_s
        && a->last_t == b->last_t && a->behind == b->behind;
}

/* Adds the passes for a unit's factors, or makes these if they are the same for all pixels. */
static void add_factors(struct glide_lines *lines, const struct glide_part *part,
                        struct glide_factors *factors)
{
    const uint32 number = part->upstream != 0;      /* units that iterate the same have their own LODs */
    const struct glide_points *points = &lines->points[part->first == GLIDE_OWN];
    const struct glide_band *band = &part->bands->of[part->band];
    const struct glide_modes *modes = &part->glide->modes;
    const int32 varies = part->by_w && (points->across.w || points->down.w);
    uint16 *values = varies ? part->scratch->lods : &lines->lods[number];
    uint8 *details = varies ? part->scratch->details : (uint8 *)&lines->details[number];
    struct glide_iterators one = {0, 0, 1 << 30};
    struct glide_nearness nearness;
    struct glide_lods lods;

    glide_factors_open(factors, band);
    if (!(band->bits & (GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER)))
        return;
    glide_lods_open(part, &lods);
    if (varies)
        glide_lines_add(lines, glide_lod, &points->at, values, &lods, sizeof lods);
    else
        glide_lod(part->by_w ? &points->start : &one, values, &lods, 1);
    if (band->bits & GLIDE_FRACTIONS_DIFFER) {
        factors->fractions = (const uint8 *)values + 1;
        factors->fraction_step = varies ? (int32)sizeof *values : 0;
    }
    if (band->bits & GLIDE_DETAILS_DIFFER) {
        nearness.end = (int16)(modes->detail_bias * 256);
        nearness.shift = (uint16)(8 - modes->detail_scale);
        if (varies)
            glide_lines_add(lines, glide_details, values, details, &nearness, sizeof nearness);
        else
            glide_details(values, details, &nearness, 1);
        factors->details = details;
        factors->detail_step = varies;
    }
}

/* Adds the pass to a unit's coordinates. */
static void add_coordinates(struct glide_lines *lines, const struct glide_part *part,
                            const struct glide_steps *from)
{
    const uint32 number = (uint32)lines->steps_used++;
    uint32 *to = (uint32 *)&lines->steps[number];
    const uint32 *longs = (const uint32 *)from;

    for (uint32 n = sizeof *from / 4; n; n--)
        *to++ = *longs++;
    lines->steps[number].skip = 0;
    lines->steps[number].left = 0;
    lines->firsts[number] = part->first;
    glide_lines_stage(lines, part->piece_bits ? glide_pieces : part->coordinates,
                      &lines->points[part->first == GLIDE_OWN].at, part->scratch->coordinates,
                      &lines->steps[number]);
}

/* Adds the passes of a unit and of those upstream. to: null if it is the frame. */
static void add_part(struct glide_lines *lines, struct glide_part *part, uint32 *to)
{
    const struct glide_band *band = &part->bands->of[part->band];
    struct glide_part *before = band->bits & GLIDE_NEEDS_OTHER ? part->upstream : 0;
    struct glide_sampling *from = &part->samplings[part->band];
    struct glide_line_scratch *work = part->scratch;
    struct glide_factors factors;
    struct glide_times times;

    if (band->bits & GLIDE_IS_OTHER) {
        add_part(lines, part->upstream, to);
        return;
    }
    if (before)
        add_part(lines, before, work->other);
    if (band->bits & GLIDE_NEEDS_OWN) {
        if (!has_coordinates(part, before))
            add_coordinates(lines, part, &from->steps);
        if (glide_part_times(part, part->band, work->other, &times)) {
            glide_lines_add(lines, glide_bilinear_times, work->coordinates, to, &times, sizeof times);
            return;
        }
        glide_lines_stage(lines, from->sample, work->coordinates,
                          band->bits & GLIDE_IS_OWN ? to : work->texels, from->level);
    }
    if (band->bits & GLIDE_IS_OWN)
        return;
    add_factors(lines, part, &factors);
    glide_combine_add(lines, &band->combining, &part->glide->modes, &factors, work->texels,
                      before ? work->other : 0, to);
}

/* Makes the texels of the last pass 5/6/5 pixels. */
static void add_store(struct glide_lines *lines, uint32 *colours)
{
    struct glide_stage *last = &lines->stages[lines->last_stage - 1];

    if (last->out == colours && (last->pass == glide_bilinear || last->pass == glide_bilinear_times)) {
        last->pass = last->pass == glide_bilinear ? glide_bilinear_565 : glide_bilinear_times_565;
        last->out = 0;
    } else {
        glide_lines_stage(lines, glide_store_565, colours, 0, 0);
    }
}

/* Notes what the passes depend on if every unit has one band. */
static void keep(struct glide_lines *lines, const struct glide_pipe *pipe,
                 const struct glide_iterations *at, const struct setup *s)
{
    lines->is_kept = 1;
    lines->is_plain = glide_may_be_plain(pipe) && pipe->chain.count == 1
        && (pipe->chain.units[0]->modes.dithered || (pipe->only.is_one && pipe->only.lod.filter == GLIDE_POINT));
    lines->own = pipe->chain.own;
    lines->scratch = s->scratch;
    for (uint32 n = 0; n < GLIDE_UNITS; n++)
        lines->divided[n] = at->divided[n];
    for (uint32 n = 0; n < pipe->chain.count; n++)
        lines->states[n] = glide_state(pipe->chain.units[n]);
}

/* Whether the passes are those of each polygon with this key. */
static int32 is_every_polygons(const struct glide_pipe *pipe, const struct glide_iterations *at)
{
    const struct glide_chain *chain = &pipe->chain;
    uint32 bits = GLIDE_NEEDS_OTHER;

    for (uint32 n = 0; n < chain->count && bits & GLIDE_NEEDS_OTHER; n++) {
        const struct glide_modes *modes = &chain->units[n]->modes;
        const int32 divided = at->divided[glide_has_own(chain) ? n : 0];

        bits = pipe->bands[n].of[0].bits;
        if (pipe->bands[n].count > 1 || bits & (GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER)
            || (modes->clamp_negative_w && divided && !modes->perspective))
            return 0;
    }
    return 1;
}

int32 glide_lines_kept(const struct glide_pipe *pipe, const struct glide_iterations *at,
                       const struct setup *s)
{
    const struct glide_lines *lines = &pipe->lines;
    const struct glide_chain *chain = &pipe->chain;

    return lines->is_kept && lines->scratch == s->scratch && lines->bits == s->frame->pixel_bytes >> 1
        && lines->divided[0] == at->divided[0] && lines->states[0] == glide_state(chain->units[0])
        && (chain->count == 1
            || (lines->states[1] == glide_state(chain->units[1]) && lines->own == chain->own
                && lines->divided[1] == at->divided[1]));
}

int32 glide_lines_find(struct glide_pipe *pipe, struct glide_plan *plan, const struct setup *s)
{
    struct glide_lines *lines = &pipe->lines;
    const struct glide_iterations *at = plan->parts->iterations;
    uint32 *const colours = plan->scratch->colours;

    lines->last_points = lines->last_stage = 0;
    lines->longs = 0;
    lines->is_full = lines->steps_used = 0;
    lines->is_kept = 0;
    for (struct glide_part *part = plan->parts; part; part = part->upstream) {
        const uint16 number = part->first == GLIDE_OWN;

        if (!is_steady(part))
            return 0;
        if (number > lines->last_points)
            lines->last_points = number;
        set_points(&lines->points[number], &at->planes, part->first, s->box.top);
    }
    add_part(lines, plan->parts, s->frame->pixel_bytes == 4 ? 0 : colours);
    if (s->frame->pixel_bytes == 2)
        add_store(lines, colours);
    lines->last_stage--;
    if (lines->is_full)
        return 0;
    lines->joins = 0;
    if (is_every_polygons(pipe, at)) {
        keep(lines, pipe, at, s);
        lines->joins = lines->steps_used == 1 && lines->last_stage
            && lines->stages[0].constants == &lines->steps[0];
    }
    return 1;
}

/* Draws the lines of a polygon whose points are set. */
static void draw(struct glide_lines *lines, const struct setup *s, struct glide_line_scratch *work)
{
    const struct frame *frame = s->frame;
    const int32 width = s->box.right - s->box.left;

    lines->lines = s->edges.lines;
    lines->count = s->box.bottom - s->box.top;
    lines->pitch = frame->pitch;
    lines->bits = frame->pixel_bytes >> 1;
    lines->pixels = frame->pixels + s->box.top * frame->pitch - EDGE_BIAS * frame->pixel_bytes;
    if (lines->joins && width <= GLIDE_TOGETHER && width * lines->count <= FRAME_SIDE_MAX)
        glide_lines_together(lines, work->unseen);
    else
        glide_lines(lines);
}

void glide_lines_draw_level(struct glide_lines *lines, const struct setup *s, struct glide_line_scratch *work)
{
    struct glide_points *points = &lines->points[0];
    struct texturing t;
    uint32 right, down;

    t.u_cut = t.v_cut = 0;
    texturing_plane(&t, &s->sides, &s->box, CHAIN_NONE);
    right = (uint32)(-EDGE_BIAS - t.i);
    down = (uint32)(s->box.top - t.j);
    points->start.s = (int32)((t.u + right * (uint32)t.dudx + down * (uint32)t.dudy) << 2);
    points->start.t = (int32)((t.v + right * (uint32)t.dvdx + down * (uint32)t.dvdy) << 2);
    points->across.s = (int32)((uint32)t.dudx << 2);
    points->across.t = (int32)((uint32)t.dvdx << 2);
    points->down.s = (int32)((uint32)t.dudy << 2);
    points->down.t = (int32)((uint32)t.dvdy << 2);
    points->at.w = points->start.w = 1 << 30;
    points->across.w = points->down.w = points->deep = 0;
    for (struct glide_steps *to = lines->steps, *end = to + lines->steps_used; to < end; to++) {
        to->s = points->across.s;
        to->t = points->across.t;
        to->w = 0;
    }
    draw(lines, s, work);
}

void glide_lines_draw(struct glide_lines *lines, const struct planes *planes, const struct setup *s,
                      struct glide_line_scratch *work)
{
    for (int32 n = lines->last_points; n >= 0; n--)
        set_points(&lines->points[n], planes, n ? GLIDE_OWN : GLIDE_S, s->box.top);
    for (int32 n = lines->steps_used - 1; n >= 0; n--) {
        const struct plane *of = &planes->of[lines->firsts[n]];
        struct glide_steps *to = &lines->steps[n];

        to->s = (int32)of[GLIDE_S].dx;
        to->t = (int32)of[GLIDE_T].dx;
        to->w = (int32)of[GLIDE_W].dx;
    }
    draw(lines, s, work);
}
