#include "tmu/plan.h"

int32 tmu_only_lod(const struct tmu *tmu, struct tmu_lod *lod)
{
    struct tmu_point least, most;
    struct tmu_lod other;

    least.w = most.w = 1 << 30;
    least.x = least.y = most.x = most.y = 0;
    least.lod = TMU_LOD_LEAST;
    most.lod = TMU_LOD_MOST;
    tmu_find_lod(tmu, &least, lod);
    tmu_find_lod(tmu, &most, &other);
    return lod->value == other.value;
}

/* Whether all pixels have one LOD. */
static int32 find_lod(const struct tmu *tmu, const struct tmu_iterations *iterations,
                      uint32 points, struct tmu_lod *lod)
{
    struct tmu_point point;

    if (tmu_only_lod(tmu, lod))
        return 1;
    if (iterations->divided[points] || tmu->modes.dither)
        return 0;
    point.w = 1 << 30;
    point.lod = iterations->points[points].lod;
    point.x = point.y = 0;
    tmu_find_lod(tmu, &point, lod);
    return 1;
}

/* Whether a unit's colours are its texels. */
static int32 shows_texels(const struct tmu_modes *modes)
{
    const struct tmu_combination *rgb = &modes->rgb, *alpha = &modes->alpha;

    return rgb->zero_other && !rgb->sub_local && rgb->add_local && !rgb->add_alpha_local
        && !rgb->invert && alpha->zero_other && !alpha->sub_local
        && (alpha->add_local || alpha->add_alpha_local) && !alpha->invert;
}

/* Passes to one level's texels. */
static int32 find_sampling(struct tmu_sampling *to, const struct tmu *tmu, struct tmu_kept *levels,
                           const struct tmu_iterations *iterations, uint32 points)
{
    const struct plane *of = &iterations->planes.of[points ? TMU_OWN : TMU_S];
    const struct tmu_modes *modes = &tmu->modes;
    int32 linear;

    if (!find_lod(tmu, iterations, points, &to->lod)
        || (iterations->divided[points] && (!modes->perspective || modes->table_quotients)))
        return 0;
    linear = to->lod.filter == TMU_BILINEAR;
    if ((linear && modes->fraction_bits != 4)
        || !tmu_decode(tmu, to->lod.level, linear, &levels[to->lod.level]))
        return 0;
    to->level = &levels[to->lod.level].decoded;
    to->first = points ? TMU_OWN : TMU_S;
    to->coordinates = iterations->divided[points] ? tmu_divide
        : modes->clamp_s || modes->clamp_t ? tmu_walk_clamp : tmu_walk;
    to->sample = linear ? tmu_bilinear : tmu_point;
    to->steps.s = (int32)of[TMU_S].dx;
    to->steps.t = (int32)of[TMU_T].dx;
    to->steps.w = (int32)of[TMU_W].dx;
    to->steps.shift = (uint16)(14 + to->lod.level);
    to->steps.half = linear ? 8 : 0;
    to->steps.behind = modes->clamp_negative_w;
    to->steps.spare = 0;
    to->steps.last_s = modes->clamp_s ? to->level->mask_s : 0xffff;
    to->steps.last_t = modes->clamp_t ? to->level->mask_t : 0xffff;
    to->combines = !shows_texels(modes);
    return !(modes->rgb.add_local && modes->rgb.add_alpha_local);
}

int32 tmu_plan_find(struct tmu_plan *plan, struct tmu_pipe *pipe,
                    const struct tmu_iterations *iterations)
{
    const struct tmu_chain *chain = &pipe->chain;

    plan->pipe = pipe;
    plan->planes = &iterations->planes;
    plan->first = shows_texels(&chain->units[0]->modes) ? 0 : chain->count - 1;
    for (uint32 n = 0; n <= plan->first; n++)
        if (!find_sampling(&plan->units[n], chain->units[n], pipe->levels[n], iterations,
                           tmu_has_own(chain) ? n : 0))
            return 0;
    plan->is_direct = !plan->units[0].combines && plan->units[0].lod.filter == TMU_BILINEAR;
    return tmu_line_ready();
}
