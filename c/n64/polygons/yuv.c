/* Passes for YUV tiles. Luma and chroma are sampled separately if a filter is on, because their
   fractions differ, and are then converted; the three-point filter has a pass that does all of this.

   A pair of texels shares its chroma. Chroma's fraction is therefore half of luma's, plus a half
   in odd columns, and its neighbours in s are those of the next pair. This is true of all columns,
   wrapped ones too. In mirrored ones odd and even change places, which the pass over coordinates
   does not allow for. */
#include "n64/polygons/plan.h"
#include "system/memory.h"

static int32 tile_allows(const struct n64 *n64, const struct n64_tile *tile)
{
    return tile->format == N64_YUV && !(n64->modes.quad && tile->s.mirror && tile->s.mask);
}

/* Finds how both texels are made; cycle 1 may convert cycle 0's texel. Returns 0 for cases without
   passes: a texel that is converted twice, one that is filtered and converted in cycle 1, and quads
   with the filter off. */
static int32 find_texels(struct n64_yuv *yuv, const struct n64_modes *modes, uint32 inputs)
{
    const int32 again = modes->convert_one && !modes->filter1;

    yuv->needed[0] = (inputs & N64_INPUT_TEXEL0) != 0;
    yuv->needed[1] = (inputs & N64_INPUT_TEXEL1) != 0;
    yuv->converted[0] = !modes->filter0;
    yuv->converted[1] = !modes->filter1;
    yuv->tile[0] = 0;
    yuv->tile[1] = !again;
    yuv->sampled[0] = yuv->needed[0] || (yuv->needed[1] && again);
    yuv->sampled[1] = yuv->needed[1] && !again;
    if (yuv->needed[1] && (again ? !modes->filter0 : modes->convert_one))
        return 0;
    return !modes->quad || ((!yuv->sampled[0] || modes->filter0)
                            && (!yuv->sampled[1] || modes->filter1));
}

void n64_form_colours(const struct n64_plan *plan, uint32 *colours, int32 count)
{
    struct n64_wide *const values = plan->scratch->tables.values;
    struct n64_wide *const results = plan->scratch->tables.results;
    struct n64_places places;

    for (int32 v = 0; v < count; v++)
        for (int32 i = 0; i < 4; i++)
            values[v].channels[i] = (int16)(v < 384 ? v : v - 512);
    places.combined = places.texel0 = places.texel1 = values;
    if (plan->form.second == N64_SECOND_TABLES)
        n64_combine_cycle(&plan->unit->n64, &places, plan->form.cycle, results, count);
    n64_narrow(plan->form.second == N64_SECOND_TABLES ? results : values, colours, 0, count);
}

static int32 find_tables(struct n64_plan *plan)
{
    struct n64_unit *unit = plan->unit;

    if (!unit->yuv || unit->yuv_made != unit->n64.mode_generation) {
        if (!unit->yuv && !mem_take(&unit->yuv, sizeof *unit->yuv, MEMORY_ANY))
            return 0;
        n64_matrix_make(&unit->yuv->matrix, unit->n64.k);
        if (!plan->form.any)
            n64_form_colours(plan, unit->yuv->colours, 512);
        unit->yuv_made = unit->n64.mode_generation;
    }
    plan->yuv.conversion.matrix = &unit->yuv->matrix;
    plan->yuv.conversion.colours = unit->yuv->colours;
    return 1;
}

int32 n64_yuv_find(struct n64_plan *plan, uint32 inputs)
{
    const struct n64 *n64 = &plan->unit->n64;
    const uint32 used = n64_tiles_used(n64);
    struct n64_yuv *yuv = &plan->yuv;
    struct n64_form *form = &plan->form;

    for (int32 n = 0; n < N64_TILES; n++)
        if (used >> n & 1 && !tile_allows(n64, &n64->tiles[n]))
            return 0;
    if (!find_texels(yuv, &n64->modes, inputs))
        return 0;
    /* Texels may leave 0 to 255, so a multiplication or blend needs all 9 bits. */
    if (form->first != N64_FIRST_TEXEL || form->second == N64_SECOND_MODULATE
        || !yuv->converted[form->swapped])
        form->any = 1;
    if (!form->any) {
        yuv->needed[!form->swapped] = 0;
        yuv->sampled[!yuv->tile[form->swapped]] = 0;
    }
    return find_tables(plan);
}

const uint32 *n64_yuv_conversion_set(struct n64_yuv_conversion *conversion,
                                     const struct n64_plan *plan,
                                     const struct n64_yuv_line *from, int32 texel)
{
    from += plan->yuv.tile[texel];
    conversion->matrix = plan->yuv.conversion.matrix;
    conversion->colours = plan->yuv.conversion.colours;
    conversion->chroma = plan->unit->n64.modes.quad ? from->chroma : from->luma;
    return from->luma;
}
