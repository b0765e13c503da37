#include "tx/plan.h"

#include "scene/scene_file.h"
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

/* Texels of a tile as cycle 0 or 1 samples it. */
static int32 find_sampling(struct tx_sampling *sampling, struct tx_unit *unit, int32 n,
                           int32 cycle)
{
    const struct tx *tx = &unit->tx;
    const struct tx_tile *tile = &tx->tiles[n & 7];
    int32 made;

    if (tile->format == TX_YUV || !(cycle ? tx->modes.filter1 : tx->modes.filter0)
        || tx_decode(tx, n & 7, tx->modes.quad, &unit->tiles[n & 7], &made) != TX_DONE)
        return 0;
    sampling->tile = &unit->tiles[n & 7].decoded;
    sampling->sample = !tx->modes.quad ? tx_point : tx->modes.mid ? tx_average : tx_threepoint;
    sampling->relative = needs_tile_pass(&tile->s) || needs_tile_pass(&tile->t) ? tx_tile : 0;
    find_axis(&sampling->axes.s, &tile->s);
    find_axis(&sampling->axes.t, &tile->t);
    return 1;
}

/* Made once for all units, when a polygon is first divided; 0: no memory. */
static const uint32 *find_reciprocals(void)
{
    static uint32 *reciprocals;

    if (!reciprocals && mem_alloc(&reciprocals, TX_RECIPROCALS * sizeof *reciprocals, MEMORY_ANY))
        tx_divide_table_make(reciprocals);
    return reciprocals;
}

static int32 find_coordinates(struct tx_plan *plan, const struct tx_planes *planes)
{
    plan->coordinates = planes->divided ? tx_divide : tx_walk;
    plan->division.s = (int32)planes->of[TX_S].dx;
    plan->division.t = (int32)planes->of[TX_T].dx;
    plan->division.w = (int32)planes->of[TX_W].dx;
    plan->division.reciprocals = planes->divided ? find_reciprocals() : 0;
    return !planes->divided || plan->division.reciprocals;
}

int32 tx_plan_find(struct tx_plan *plan, const struct tx_needs *needs, const struct setup *s,
                   struct tx_unit *unit, const struct tx_planes *planes)
{
    const struct tx *tx = &unit->tx;

    if (tx->modes.lod || needs->inputs & (TX_INPUT_SHADE | TX_INPUT_LOD_FRACTION)
        || !tx_combine_is_texel(tx) || !find_coordinates(plan, planes))
        return 0;
    plan->combine = 0;
    plan->texel[1].sample = 0;
    plan->store = s->frame->pixel_bytes == 2 ? tx_store_16 : 0;
    return find_sampling(&plan->texel[0], unit, tx->primitive_tile, 0);
}

static void sample(const struct tx_sampling *from, const uint32 *coordinates, uint32 *texels,
                   int32 count)
{
    static uint32 relative[SCENE_SIDE_MAX];

    if (from->relative) {
        from->relative(coordinates, relative, &from->axes, count);
        coordinates = relative;
    }
    from->sample(coordinates, texels, from->tile, count);
}

void tx_plan_draw(const struct tx_plan *plan, const struct tx_planes *planes,
                  const struct frame *frame, int32 x, int32 y, int32 count)
{
    static uint32 coordinates[SCENE_SIDE_MAX], room[SCENE_SIDE_MAX];
    uint8 *pixels = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    uint32 *texels = plan->store ? room : (uint32 *)pixels;
    struct tx_iterators at;

    at.s = (int32)tx_plane_at(planes, TX_S, x, y);
    at.t = (int32)tx_plane_at(planes, TX_T, x, y);
    at.w = (int32)tx_plane_at(planes, TX_W, x, y);
    plan->coordinates(&at, coordinates, &plan->division, count);
    sample(&plan->texel[0], coordinates, texels, count);
    if (plan->store)
        plan->store(texels, pixels, 0, count);
}
