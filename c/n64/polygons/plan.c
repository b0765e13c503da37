#include "n64/polygons/plan.h"

#include "polygon/scratch.h"
#include "system/memory.h"

SCRATCH_FITS_UNIT(union n64_scratch);

static int32 needs_tile_pass(const struct n64_axis *axis)
{
    return axis->shift || axis->low || axis->clamp || !axis->mask;
}

static void find_axis(struct n64_axis_range *to, const struct n64_axis *axis)
{
    to->shift = (int16)(axis->shift <= 10 ? axis->shift : axis->shift - 16);
    to->clamp = axis->clamp || !axis->mask;
    to->low = (int16)(axis->low * 8);
    to->high = (int16)(axis->high * 8);
    to->last = (int16)((((axis->high >> 2) - (axis->low >> 2)) & 0x3ff) << 5);
}

/* Returns non-zero if an axis shows one texel without a fraction, whatever the coordinate. */
static int32 is_single(const struct n64_axis *axis)
{
    return (axis->clamp || !axis->mask) && !axis->low && !axis->high;
}

/* Returns non-zero if coordinates are relative to the axis once they are shifted, or need not be:
   the axis is single. */
static int32 is_shifted(const struct n64_axis *axis)
{
    return (!axis->clamp && axis->mask && !axis->low) || is_single(axis);
}

/* Returns the shift to the right that makes coordinates relative to a tile, or -1: they need more.
   s and t are shifted as one long. Bits of s enter t from above, and s lacks its sign there: the
   tile's masks must cut these off. */
static int32 only_shift(const struct n64_tile *tile, const struct n64_decoded *decoded)
{
    const int32 shift = tile->s.shift;
    const uint32 masks = (uint32)decoded->mask_s | decoded->mask_t;

    return shift == tile->t.shift && shift <= 10 && is_shifted(&tile->s) && is_shifted(&tile->t)
        && !(masks >> (16 - shift)) ? shift : -1;
}

/* Texels of a tile; 0: they cannot be decoded ahead. */
static int32 find_sampling(struct n64_sampling *sampling, struct n64_unit *unit, int32 n,
                           union n64_scratch *scratch)
{
    const struct n64 *n64 = &unit->n64;
    const struct n64_tile *tile = &n64->tiles[n];
    const int32 is_apart = tile->format == N64_YUV && n64->modes.quad;
    const enum n64_quads quads = n64->modes.quad ? N64_QUADS_NEXT : N64_QUADS_NONE;
    struct n64_decoding decoding;

    decoding.scratch = &scratch->decode;
    decoding.colours = &unit->colours;
    if (n64_decode(&decoding, n64, n, quads, &unit->tiles[n]) != N64_DONE
        || (is_apart && n64_decode(&decoding, n64, n, N64_QUADS_CHROMA, &unit->chroma[n])
                        != N64_DONE))
        return 0;
    sampling->tile = &unit->tiles[n].decoded;
    sampling->chroma = is_apart ? &unit->chroma[n].decoded : 0;
    sampling->sample = !n64->modes.quad ? n64_point : n64->modes.mid ? n64_average : n64_threepoint;
    sampling->relative = needs_tile_pass(&tile->s) || needs_tile_pass(&tile->t) ? n64_tile : 0;
    sampling->shift = only_shift(tile, sampling->tile);
    sampling->fractions = (is_single(&tile->s) ? 0 : 31u << 16) | (is_single(&tile->t) ? 0 : 31u);
    find_axis(&sampling->axes.s, &tile->s);
    find_axis(&sampling->axes.t, &tile->t);
    return 1;
}

/* Finds whether the second texel is needed. Returns 0 if there are no passes: for the texels'
   modes, or because a used tile is YUV though the first is not. */
static int32 find_rgb(struct n64_plan *plan, uint32 used, uint32 inputs)
{
    const struct n64 *n64 = &plan->unit->n64;
    const struct n64_form *form = &plan->form;
    const int32 is_one = !form->any && form->first == N64_FIRST_TEXEL;

    plan->second_texel = !is_one && inputs & N64_INPUT_TEXEL1;
    for (int32 n = 0; n < N64_TILES; n++)
        if (used >> n & 1 && n64->tiles[n].format == N64_YUV)
            return 0;
    if ((plan->second_texel || (is_one && form->swapped))
        && (!n64->modes.filter1 || n64->modes.convert_one))
        return 0;
    return n64->modes.filter0;
}

static int32 find_samplings(struct n64_plan *plan, uint32 inputs)
{
    const struct n64 *n64 = &plan->unit->n64;
    uint32 used = n64_tiles_used(n64);

    plan->yuv.on = n64->tiles[n64->primitive_tile & 7].format == N64_YUV;
    if (!(plan->yuv.on ? n64_yuv_find(plan, inputs) : find_rgb(plan, used, inputs)))
        return 0;
    if (plan->yuv.on && !plan->levels)
        used = (uint32)plan->yuv.sampled[0] << plan->tile0
            | (uint32)plan->yuv.sampled[1] << plan->tile1;
    for (int32 n = 0; n < N64_TILES; n++)
        if (used >> n & 1 && !find_sampling(&plan->tiles[n], plan->unit, n, plan->scratch))
            return 0;
    return 1;
}

/* Returns the reciprocals, made once for all units when first needed; null: no memory. */
static const uint32 *find_reciprocals(struct n64_unit *unit)
{
    uint32 **of = unit->reciprocals;

    if (!*of && mem_take(of, N64_RECIPROCALS * sizeof **of, MEMORY_ANY))
        n64_divide_table_make(*of);
    return *of;
}

/* Returns the blendings of levels, made again when what they depend on changes; null: no
   memory. */
static const struct n64_levels *find_levels(struct n64_plan *plan)
{
    struct n64_unit *unit = plan->unit;
    const struct n64 *n64 = &unit->n64;
    struct n64_level_modes *of = &unit->levels_of;
    struct n64_level_modes modes;

    modes.lod = n64->modes.lod;
    modes.sharpen = n64->modes.sharpen;
    modes.detail = n64->modes.detail;
    modes.max_level = n64->max_level;
    modes.min_level = n64->min_level;
    modes.tile = n64->primitive_tile;
    modes.only_blends = (uint8)plan->only_blends;
    if (unit->levels && of->lod == modes.lod && of->sharpen == modes.sharpen
        && of->detail == modes.detail && of->max_level == modes.max_level
        && of->min_level == modes.min_level && of->tile == modes.tile
        && of->only_blends == modes.only_blends)
        return unit->levels;
    if (!unit->levels && !mem_take(&unit->levels, sizeof *unit->levels, MEMORY_ANY))
        return 0;
    n64_levels_make(unit->levels, &modes);
    of->lod = modes.lod;
    of->sharpen = modes.sharpen;
    of->detail = modes.detail;
    of->max_level = modes.max_level;
    of->min_level = modes.min_level;
    of->tile = modes.tile;
    of->only_blends = modes.only_blends;
    return unit->levels;
}

/* Finds the pass from iterators to coordinates; returns 0 if there is no memory. */
static int32 find_coordinates(struct n64_plan *plan, int32 divided)
{
    const uint32 *reciprocals;

    plan->coordinates = plan->levels ? n64_lod : divided ? n64_divide : n64_walk;
    if (plan->coordinates == n64_walk)
        return 1;
    reciprocals = find_reciprocals(plan->unit);
    if (!plan->levels) {
        plan->steps.division.reciprocals = reciprocals;
        return reciprocals != 0;
    }
    plan->steps.lod.reciprocals = reciprocals;
    plan->steps.lod.levels = find_levels(plan);
    plan->steps.lod.blendings = plan->scratch->line.blendings;
    return reciprocals && plan->steps.lod.levels;
}

void n64_plan_walk(struct n64_plan *plan, const struct n64_planes *planes)
{
    const struct plane *of = planes->all.of;

    plan->planes = planes;
    plan->stages.planes = of;
    plan->stages.column = planes->all.i;
    plan->steps.walk.s = (int32)of[N64_S].dx;
    plan->steps.walk.t = (int32)of[N64_T].dx;
}

/* Sets a polygon's planes. Without perspective w stays 0x7fff, and division by it changes nothing.
   In one-cycle mode the level does not depend on the pixel below. */
static void set_planes(struct n64_plan *plan, const struct n64_planes *planes)
{
    const struct plane *of = planes->all.of;
    const int32 down = plan->unit->n64.modes.cycle != N64_ONE_CYCLE;

    n64_plan_walk(plan, planes);
    plan->steps.walk.w = (int32)of[N64_W].dx;
    if (plan->levels)
        for (int32 i = N64_S; i <= N64_W; i++)
            (&plan->steps.lod.y_s)[i] = down ? (int32)of[i].dy : 0;
    for (int32 i = 0; i < 4; i++)
        (&plan->shade_steps.r)[i] = (int32)of[N64_RED + i].dx;
}

/* Makes the tables of the form's second part; returns 0 if there is no memory. */
static int32 find_tables(struct n64_plan *plan)
{
    struct n64_unit *unit = plan->unit;

    plan->tables = unit->tables;
    if (unit->tables && unit->tables_made == unit->n64.mode_generation)
        return 1;
    if (!unit->tables && !mem_take(&unit->tables, 256 * sizeof *unit->tables, MEMORY_ANY))
        return 0;
    n64_form_colours(plan, unit->tables, 256);
    unit->tables_made = unit->n64.mode_generation;
    plan->tables = unit->tables;
    return 1;
}

static uint32 packed(const struct n64_colour *colour)
{
    return (uint32)colour->r << 24 | (uint32)colour->g << 16 | (uint32)colour->b << 8
        | (uint32)colour->a;
}

/* Finds all that depends on the state; returns 0 if there are no passes, or no memory. */
static int32 find(struct n64_plan *plan, const struct n64_needs *needs, int32 pixel_bytes)
{
    const struct n64 *n64 = &plan->unit->n64;

    plan->levels = n64->modes.lod || needs->inputs & N64_INPUT_LOD_FRACTION;
    plan->shaded = (needs->inputs & N64_INPUT_SHADE) != 0;
    plan->tile0 = n64->primitive_tile;
    plan->tile1 = (n64->primitive_tile + 1) & 7;
    plan->shade = packed(&needs->shade);
    n64_form_find(&plan->form, n64);
    if (!(n64->inputs & N64_INPUT_TEXEL1))      /* nothing depends on the texel: its tile may have no texels */
        plan->form.swapped = 0;
    if (!find_samplings(plan, needs->inputs))
        return 0;
    plan->only_blends = plan->levels && !plan->yuv.on && !plan->form.any
        && plan->form.first == N64_FIRST_BLEND && plan->form.fraction < 0;
    if (!find_coordinates(plan, needs->divided))
        return 0;
    plan->is_direct = !plan->yuv.on && !plan->form.any && plan->form.first == N64_FIRST_TEXEL
        && plan->form.second == N64_SECOND_NOTHING && n64->modes.quad && !n64->modes.mid;
    if (!plan->yuv.on && !plan->form.any && plan->form.second == N64_SECOND_TABLES
        && !find_tables(plan))
        return 0;
    n64_stages_find(plan, pixel_bytes);
    return 1;
}

struct n64_plan *n64_plan_find(const struct n64_needs *needs, struct n64_unit *unit,
                               const struct n64_planes *planes, int32 pixel_bytes, uint32 *room)
{
    const uint32 state = n64_unit_state(unit), shade = packed(&needs->shade);
    struct n64_plan *plan;
    struct n64_plan_key *key;

    if (!unit->plan && !mem_take(&unit->plan, sizeof *unit->plan, MEMORY_ANY))
        return 0;
    plan = unit->plan;
    key = &plan->key;
    if (key->state != state || key->inputs != needs->inputs || key->shade != shade
        || key->divided != needs->divided || key->pixel_bytes != pixel_bytes
        || key->room != room) {
        key->state = 0;
        plan->scratch = (union n64_scratch *)room;
        plan->unit = unit;
        if (!find(plan, needs, pixel_bytes))
            return 0;
        key->state = state;
        key->inputs = needs->inputs;
        key->shade = shade;
        key->divided = needs->divided;
        key->pixel_bytes = pixel_bytes;
        key->room = room;
    }
    set_planes(plan, planes);
    return plan;
}
