/* YUV tiles by passes. Luma and chroma are sampled apart where a filter weighs them apart, and
   converted after that.

   Chroma under a filter: a pair of texels shares it, so that its fraction is half of luma's, and
   another half in odd columns; the texels beside it are those of the next pair. Both hold for
   every column that is shown, wrapped ones too; of mirrored ones odd and even change places,
   which the pass over coordinates does not know. */
#include "polygon/line_room.h"
#include "system/system.h"
#include "tx/plan.h"

static int32 tile_allows(const struct tx *tx, const struct tx_tile *tile)
{
    return tile->format == TX_YUV && !(tx->modes.quad && tile->s.mirror && tile->s.mask);
}

/* Cycle 1 may convert cycle 0's texel. Left to others: converting what is converted already,
   both filtering and converting that texel, and the corner of a quad that is left where a filter
   is off. */
static int32 find_texels(struct tx_yuv *yuv, const struct tx_modes *modes, uint32 inputs)
{
    const int32 again = modes->convert_one && !modes->filter1;

    yuv->needed[0] = (inputs & TX_INPUT_TEXEL0) != 0;
    yuv->needed[1] = (inputs & TX_INPUT_TEXEL1) != 0;
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

/* Colours of a converted channel's 9 bits, what the form's second part makes of it. */
static void make_colours(const struct tx_plan *plan, uint32 *colours)
{
    struct tx_wide *const values = (struct tx_wide *)line_room, *const results = values + 512;
    struct tx_places places;

    for (int32 v = 0; v < 512; v++)
        for (int32 i = 0; i < 4; i++)
            values[v].channels[i] = (int16)(v < 384 ? v : v - 512);
    places.combined = places.texel0 = places.texel1 = values;
    if (plan->form.second == TX_SECOND_TABLES)
        tx_combine_cycle(&plan->unit->tx, &places, plan->form.cycle, results, 512);
    tx_narrow(plan->form.second == TX_SECOND_TABLES ? results : values, colours, 0, 512);
}

static int32 find_tables(struct tx_plan *plan)
{
    struct tx_unit *unit = plan->unit;

    if (!unit->yuv || unit->yuv_made != unit->tx.mode_generation) {
        if (!unit->yuv && !mem_take(&unit->yuv, sizeof *unit->yuv, MEMORY_ANY))
            return 0;
        tx_matrix_make(&unit->yuv->matrix, unit->tx.k);
        if (!plan->form.any)
            make_colours(plan, unit->yuv->colours);
        unit->yuv_made = unit->tx.mode_generation;
    }
    plan->yuv.conversion.matrix = &unit->yuv->matrix;
    plan->yuv.conversion.colours = unit->yuv->colours;
    return 1;
}

int32 tx_yuv_find(struct tx_plan *plan, uint32 inputs)
{
    const struct tx *tx = &plan->unit->tx;
    const uint32 used = tx_tiles_used(tx);
    struct tx_yuv *yuv = &plan->yuv;
    struct tx_form *form = &plan->form;

    for (int32 n = 0; n < TX_TILES; n++)
        if (used >> n & 1 && !tile_allows(tx, &tx->tiles[n]))
            return 0;
    if (!find_texels(yuv, &tx->modes, inputs))
        return 0;
    /* Texels may leave 0 to 255: what multiplies or blends them has to have their 9 bits. */
    if (form->first != TX_FIRST_TEXEL || form->second == TX_SECOND_MODULATE
        || !yuv->converted[form->swapped])
        form->any = 1;
    if (!form->any) {
        yuv->needed[!form->swapped] = 0;
        yuv->sampled[!yuv->tile[form->swapped]] = 0;
    }
    return find_tables(plan);
}

/* Of one texel. */
static struct tx_yuv_conversion conversion_of(const struct tx_plan *plan,
                                              const struct tx_yuv_line *from)
{
    struct tx_yuv_conversion conversion = plan->yuv.conversion;

    conversion.chroma = plan->unit->tx.modes.quad ? from->chroma : from->luma;
    return conversion;
}

void tx_yuv_colours(const struct tx_plan *plan, const struct tx_yuv_line *from, uint32 *colours,
                    int32 count)
{
    struct tx_yuv_conversion conversion;

    from += plan->yuv.tile[plan->form.swapped];
    conversion = conversion_of(plan, from);
    tx_convert(from->luma, colours, &conversion, count);
}

void tx_yuv_widen(const struct tx_plan *plan, const struct tx_yuv_line *from, int32 texel,
                  struct tx_wide *wide, int32 count)
{
    struct tx_yuv_conversion conversion;

    from += plan->yuv.tile[texel];
    conversion = conversion_of(plan, from);
    if (plan->yuv.converted[texel]) {
        tx_convert_wide(from->luma, wide, &conversion, count);
        return;
    }
    tx_widen(from->luma, wide, 0, count);
    for (int32 i = 0; i < count; i++, wide++) {
        wide->channels[0] = (int16)((conversion.chroma[i] >> 24) - 128);
        wide->channels[1] = (int16)((conversion.chroma[i] >> 16 & 255) - 128);
    }
}
