#include "glide/polygons/tiles.h"
#include "system/memory.h"

int32 glide_only_lod(const struct glide *glide, struct glide_lod *lod)
{
    const struct glide_modes *modes = &glide->modes;
    const int32 least = glide_lod_least(modes), most = glide_lod_most(modes);

    glide_lod_at(modes, least < most ? least : most, lod);
    return least >= most;
}

/* Decodes a level and returns the pass that samples it; null if there is no memory even for the
   texels. */
static glide_pass *find_sample(struct glide_part *part, const struct glide_lod *lod)
{
    const int32 is_fine = part->glide->modes.fraction_bits == 8;
    struct glide_kept *kept = &part->levels[lod->level];
    struct glide_bytes *bytes = &part->scratch->bytes;

    if (lod->filter == GLIDE_BILINEAR && glide_decode(part->glide, lod->level, 1, kept, bytes))
        return is_fine ? glide_bilinear_8 : glide_bilinear;
    if (!glide_decode(part->glide, lod->level, 0, kept, bytes))
        return 0;
    return lod->filter != GLIDE_BILINEAR ? glide_point : is_fine ? glide_filter_line_8 : glide_filter_line;
}

struct glide_sampling *glide_sampling_find(struct glide_part *part, uint32 band)
{
    struct glide_sampling *to = &part->samplings[band];
    const struct glide_lod *lod = &part->bands->of[band].lod;
    const struct glide_modes *modes = &part->glide->modes;
    const int32 linear = lod->filter == GLIDE_BILINEAR, bits = linear ? modes->fraction_bits : 4;

    to->sample = find_sample(part, lod);
    if (!to->sample)
        return 0;
    to->level = &part->levels[lod->level].decoded;
    to->steps.shift = (uint16)(18 - bits + lod->level);
    to->steps.half = linear ? (uint16)(1 << (bits - 1)) : 0;
    to->steps.behind = modes->clamp_negative_w;
    to->steps.bits = (uint16)part->piece_bits;
    to->steps.skip = to->steps.spare = 0;
    to->steps.left = 0;
    to->steps.last_s = modes->clamp_s ? (uint16)(to->level->mask_s << (bits - 4)) : 0xffff;
    to->steps.last_t = modes->clamp_t ? (uint16)(to->level->mask_t << (bits - 4)) : 0xffff;
    return to;
}

/* Finds the bands that pixels of the polygon may have. */
static void find_bands(struct glide_part *part, const struct glide_range *range)
{
    static const struct glide_range one = {1 << 30, 1 << 30};
    const struct glide_range *sizes = part->by_w ? range : &one;
    uint32 last = part->bands->count - 1;

    part->band = 0;
    if (sizes->least > 0) {
        part->band = glide_runs_band(part, 0, sizes->most);
        last = glide_runs_band(part, part->glide->modes.dither ? GLIDE_DITHERS - 1 : 0, sizes->least);
    }
    if (range->least > 0)
        part->hides_behind = 0;
    part->last = last;
    part->is_one = part->band == last && !part->hides_behind;
    part->bits = 0;
    part->every = ~(uint32)0;
    for (uint32 n = part->band; n <= last; n++) {
        part->bits |= part->bands->of[n].bits;
        part->every &= part->bands->of[n].bits;
    }
}

/* Gives all units the table of logarithms, made when a unit first needs LODs; 0: no memory. */
static int32 set_logarithms(struct glide_plan *plan, struct glide_tile_store *store)
{
    if (!store->logarithms
        && mem_take(&store->logarithms, GLIDE_LOGARITHMS * sizeof *store->logarithms, MEMORY_ANY))
        glide_logarithms_make(store->logarithms, glide_logarithms);
    for (struct glide_part *part = plan->parts; part; part = part->upstream)
        part->logarithms = store->logarithms;
    return store->logarithms != 0;
}

/* Gives a unit the table of products, made when one first multiplies what it filters. */
static void set_products(struct glide_part *part, struct glide_tile_store *store)
{
    part->products = 0;
    if (!(part->bits & GLIDE_IS_TIMES))
        return;
    if (!store->products && mem_take(&store->products, GLIDE_PRODUCTS_BYTES, MEMORY_ANY))
        glide_products_make(store->products);
    if (store->products)
        part->products = store->products + GLIDE_PRODUCTS;
}

/* 0: the unit's pixels have no passes. */
static int32 find_part(struct glide_part *part, struct glide_pipe *pipe, uint32 unit,
                       const struct glide_iterations *iterations, int32 has_alpha)
{
    const uint32 points = glide_has_own(&pipe->chain) ? unit : 0;
    const struct glide *glide = pipe->chain.units[unit];
    const struct glide_modes *modes = &glide->modes;
    const int32 divides = iterations->divided[points] && modes->perspective;

    if ((divides && modes->table_quotients)
        || (modes->rgb.add_local && modes->rgb.add_alpha_local))
        return 0;
    glide_bands_find(&pipe->bands[unit], glide, unit + 1 < pipe->chain.count, has_alpha);
    part->upstream = 0;
    part->glide = glide;
    part->levels = pipe->levels[unit];
    part->bands = &pipe->bands[unit];
    part->iterations = iterations;
    part->first = points ? GLIDE_OWN : GLIDE_S;
    part->lod = iterations->points[points].lod + modes->lod_bias * 64;
    part->by_w = modes->perspective;
    part->piece_bits = divides ? glide_piece_bits(&pipe->chain, unit) : 0;
    part->coordinates = part->piece_bits ? glide_pieces : divides ? glide_divide
        : modes->clamp_s || modes->clamp_t ? glide_walk_clamp : glide_walk;
    part->hides_behind = modes->clamp_negative_w && !divides;
    part->ready = 0;
    find_bands(part, &iterations->ranges[points]);
    for (uint32 band = 0; band < part->bands->count; band++)
        part->samplings[band].level = 0;
    return 1;
}

int32 glide_plan_find(struct glide_plan *plan, struct glide_pipe *pipe,
                      const struct glide_iterations *iterations, int32 pixel_bytes)
{
    const uint32 varies = GLIDE_DETAILS_DIFFER | GLIDE_FRACTIONS_DIFFER;
    struct glide_part **place = 0, *part = plan->parts;
    int32 lods = 0, varied = 0, has_alpha = pixel_bytes == 4;
    uint32 bits = GLIDE_NEEDS_OTHER;

    plan->is_dithered = 0;
    plan->has_mips = 1;
    for (uint32 n = 0; n < pipe->chain.count && bits & GLIDE_NEEDS_OTHER; n++) {
        if (!find_part(part, pipe, n, iterations, has_alpha))
            return 0;
        part->scratch = plan->scratch;
        bits = part->bits;
        has_alpha = (bits & GLIDE_NEEDS_OTHER_ALPHA) != 0;
        set_products(part, pipe->tiles);
        if (!place && part->every & GLIDE_IS_OTHER)
            continue;                   /* nothing of this unit is seen */
        if (place)
            *place = part;
        place = &part->upstream;
        plan->is_dithered |= part->glide->modes.dither && !part->is_one;
        lods |= plan->is_dithered || bits & varies;
        glide_mips_open(part);
        plan->has_mips &= part->mixing != 0;
        varied |= !part->is_one;
        part++;
    }
    plan->is_direct = (plan->parts[0].every & GLIDE_IS_OWN) != 0;
    plan->has_mips &= varied && (plan->is_dithered || plan->parts[0].mixes);
    return !(lods || plan->has_mips) || set_logarithms(plan, pipe->tiles);
}
