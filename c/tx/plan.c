#include "tx/plan.h"

#include "system/system.h"

static int32 needs_tile_pass(const struct tx_axis *axis)
{
    return axis->shift || axis->low || axis->clamp || !axis->mask;
}

static void find_axis(struct tx_axis_range *to, const struct tx_axis *axis)
{
    to->shift = (int16)(axis->shift <= 10 ? axis->shift : axis->shift - 16);
    to->clamp = axis->clamp || !axis->mask;
    to->low = (int16)(axis->low * 8);
    to->high = (int16)(axis->high * 8);
    to->last = (int16)((((axis->high >> 2) - (axis->low >> 2)) & 0x3ff) << 5);
}

/* Texels of a tile; 0: they cannot be decoded ahead. */
static int32 find_sampling(struct tx_sampling *sampling, struct tx_unit *unit, int32 n)
{
    const struct tx *tx = &unit->tx;
    const struct tx_tile *tile = &tx->tiles[n];
    const int32 is_apart = tile->format == TX_YUV && tx->modes.quad;
    int32 made;

    if (tx_decode(tx, n, tx->modes.quad ? TX_QUADS_NEXT : TX_QUADS_NONE, &unit->tiles[n], &made)
        != TX_DONE
        || (is_apart && tx_decode(tx, n, TX_QUADS_CHROMA, &unit->chroma[n], &made) != TX_DONE))
        return 0;
    sampling->tile = &unit->tiles[n].decoded;
    sampling->chroma = is_apart ? &unit->chroma[n].decoded : 0;
    sampling->sample = !tx->modes.quad ? tx_point : tx->modes.mid ? tx_average : tx_threepoint;
    sampling->relative = needs_tile_pass(&tile->s) || needs_tile_pass(&tile->t) ? tx_tile : 0;
    find_axis(&sampling->axes.s, &tile->s);
    find_axis(&sampling->axes.t, &tile->t);
    return 1;
}

/* Which of both texels are needed; 0: their modes, or YUV among others, have no passes. */
static int32 find_rgb(struct tx_plan *plan, uint32 used, uint32 inputs)
{
    const struct tx *tx = &plan->unit->tx;
    const struct tx_form *form = &plan->form;
    const int32 is_one = !form->any && form->first == TX_FIRST_TEXEL;

    plan->second_texel = !is_one && inputs & TX_INPUT_TEXEL1;
    for (int32 n = 0; n < TX_TILES; n++)
        if (used >> n & 1 && tx->tiles[n].format == TX_YUV)
            return 0;
    if ((plan->second_texel || (is_one && form->swapped))
        && (!tx->modes.filter1 || tx->modes.convert_one))
        return 0;
    return tx->modes.filter0;
}

static int32 find_samplings(struct tx_plan *plan, uint32 inputs)
{
    const struct tx *tx = &plan->unit->tx;
    uint32 used = tx_tiles_used(tx);

    plan->yuv.on = tx->tiles[tx->primitive_tile & 7].format == TX_YUV;
    if (!(plan->yuv.on ? tx_yuv_find(plan, inputs) : find_rgb(plan, used, inputs)))
        return 0;
    if (plan->yuv.on && !plan->levels)
        used = (uint32)plan->yuv.sampled[0] << plan->tile0
            | (uint32)plan->yuv.sampled[1] << plan->tile1;
    for (int32 n = 0; n < TX_TILES; n++)
        if (used >> n & 1 && !find_sampling(&plan->tiles[n], plan->unit, n))
            return 0;
    return 1;
}

/* Made once for all units, when they are first needed; 0: no memory. */
static const uint32 *find_reciprocals(void)
{
    static uint32 *reciprocals;

    if (!reciprocals && mem_take(&reciprocals, TX_RECIPROCALS * sizeof *reciprocals, MEMORY_ANY))
        tx_divide_table_make(reciprocals);
    return reciprocals;
}

/* Blendings of levels, made again when the modes change; 0: no memory. */
static const struct tx_levels *find_levels(struct tx_unit *unit)
{
    const struct tx *tx = &unit->tx;
    struct tx_level_modes modes;

    if (unit->levels && unit->levels_made == tx->mode_generation)
        return unit->levels;
    if (!unit->levels && !mem_take(&unit->levels, sizeof *unit->levels, MEMORY_ANY))
        return 0;
    modes.lod = tx->modes.lod;
    modes.sharpen = tx->modes.sharpen;
    modes.detail = tx->modes.detail;
    modes.max_level = tx->max_level;
    modes.min_level = tx->min_level;
    modes.tile = tx->primitive_tile;
    tx_levels_make(unit->levels, &modes);
    unit->levels_made = tx->mode_generation;
    return unit->levels;
}

/* Without perspective w stays 0x7fff, by which a divide changes nothing. In one-cycle mode the
   pixel below does not count. */
static int32 find_lod(struct tx_plan *plan)
{
    const struct plane *of = plan->planes->all.of;
    struct tx_lod_steps *lod = &plan->steps.lod;
    const int32 down = plan->unit->tx.modes.cycle != TX_ONE_CYCLE;

    plan->coordinates = tx_lod;
    lod->s = lod->x_s = (int32)of[TX_S].dx;
    lod->t = lod->x_t = (int32)of[TX_T].dx;
    lod->w = lod->x_w = (int32)of[TX_W].dx;
    lod->y_s = down ? (int32)of[TX_S].dy : 0;
    lod->y_t = down ? (int32)of[TX_T].dy : 0;
    lod->y_w = down ? (int32)of[TX_W].dy : 0;
    lod->reciprocals = find_reciprocals();
    lod->levels = find_levels(plan->unit);
    lod->blendings = tx_line_blendings();
    return lod->reciprocals && lod->levels;
}

static int32 find_coordinates(struct tx_plan *plan)
{
    const struct plane *of = plan->planes->all.of;
    struct tx_division *division = &plan->steps.division;

    if (plan->levels)
        return find_lod(plan);
    plan->coordinates = plan->planes->divided ? tx_divide : tx_walk;
    plan->steps.walk.s = (int32)of[TX_S].dx;
    plan->steps.walk.t = (int32)of[TX_T].dx;
    plan->steps.walk.w = (int32)of[TX_W].dx;
    if (plan->planes->divided)
        division->reciprocals = find_reciprocals();
    return !plan->planes->divided || division->reciprocals;
}

/* Tables of what the form's second part makes of each value: a line that has them all. */
static int32 find_tables(struct tx_plan *plan)
{
    static struct tx_wide values[256], results[256];
    struct tx_unit *unit = plan->unit;
    struct tx_places places;
    uint32 colours[256];

    plan->tables = unit->tables;
    if (unit->tables && unit->tables_made == unit->tx.mode_generation)
        return 1;
    if (!unit->tables && !mem_take(&unit->tables, 4 * 256, MEMORY_ANY))
        return 0;
    for (int32 v = 0; v < 256; v++)
        for (int32 i = 0; i < 4; i++)
            values[v].channels[i] = (int16)v;
    places.combined = places.texel0 = places.texel1 = values;
    tx_combine_cycle(&unit->tx, &places, plan->form.cycle, results, 256);
    tx_narrow(results, colours, 0, 256);
    for (int32 v = 0; v < 256; v++)
        for (int32 i = 0; i < 4; i++)
            unit->tables[256 * i + v] = (uint8)(colours[v] >> (24 - 8 * i));
    unit->tables_made = unit->tx.mode_generation;
    plan->tables = unit->tables;
    return 1;
}

static uint32 packed(const struct tx_colour *colour)
{
    return (uint32)colour->r << 24 | (uint32)colour->g << 16 | (uint32)colour->b << 8
        | (uint32)colour->a;
}

int32 tx_plan_find(struct tx_plan *plan, const struct tx_needs *needs, struct tx_unit *unit,
                   const struct tx_planes *planes)
{
    const struct tx *tx = &unit->tx;

    plan->unit = unit;
    plan->planes = planes;
    plan->levels = tx->modes.lod || needs->inputs & TX_INPUT_LOD_FRACTION;
    plan->tile0 = tx->primitive_tile;
    plan->tile1 = (tx->primitive_tile + 1) & 7;
    plan->shade = packed(&needs->shade);
    tx_form_find(&plan->form, tx);
    if (!find_samplings(plan, needs->inputs) || !find_coordinates(plan))
        return 0;
    plan->is_direct = !plan->yuv.on && !plan->form.any && plan->form.first == TX_FIRST_TEXEL
        && plan->form.second == TX_SECOND_NOTHING && tx->modes.quad && !tx->modes.mid;
    return plan->yuv.on || plan->form.any || plan->form.second != TX_SECOND_TABLES
        || find_tables(plan);
}
