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

/* Passes to one level's texels. */
static int32 find_sampling(struct tmu_sampling *to, const struct tmu *tmu, struct tmu_kept *levels,
                           const struct tmu_iterations *iterations, uint32 points)
{
    const struct plane *of = &iterations->planes.of[points ? TMU_OWN : TMU_S];
    const struct tmu_modes *modes = &tmu->modes;
    int32 linear, bits;

    if (!find_lod(tmu, iterations, points, &to->lod)
        || (iterations->divided[points] && (!modes->perspective || modes->table_quotients)))
        return 0;
    linear = to->lod.filter == TMU_BILINEAR;
    bits = linear ? modes->fraction_bits : 4;
    if (!tmu_decode(tmu, to->lod.level, linear, &levels[to->lod.level]))
        return 0;
    to->level = &levels[to->lod.level].decoded;
    to->first = points ? TMU_OWN : TMU_S;
    to->coordinates = iterations->divided[points] ? tmu_divide
        : modes->clamp_s || modes->clamp_t ? tmu_walk_clamp : tmu_walk;
    to->sample = !linear ? tmu_point : bits == 8 ? tmu_bilinear_8 : tmu_bilinear;
    to->steps.s = (int32)of[TMU_S].dx;
    to->steps.t = (int32)of[TMU_T].dx;
    to->steps.w = (int32)of[TMU_W].dx;
    to->steps.shift = (uint16)(18 - bits + to->lod.level);
    to->steps.half = linear ? (uint16)(1 << (bits - 1)) : 0;
    to->steps.behind = modes->clamp_negative_w;
    to->steps.spare = 0;
    to->steps.last_s = modes->clamp_s ? (uint16)(to->level->mask_s << (bits - 4)) : 0xffff;
    to->steps.last_t = modes->clamp_t ? (uint16)(to->level->mask_t << (bits - 4)) : 0xffff;
    return !(modes->rgb.add_local && modes->rgb.add_alpha_local);
}

/* Whether nothing of a unit is seen but what comes from upstream. */
static int32 is_passed(struct tmu_combining *combining, const struct tmu_modes *modes,
                       int32 has_other, int32 has_alpha)
{
    struct tmu_known known;

    known.detail = known.fraction = -1;
    known.flip = modes->trilinear ? -1 : 0;
    tmu_combining_find(combining, modes, &known, has_other, has_alpha);
    return tmu_shows(combining, TMU_TERM_OTHER);
}

int32 tmu_plan_find(struct tmu_plan *plan, struct tmu_pipe *pipe,
                    const struct tmu_iterations *iterations, int32 pixel_bytes)
{
    const struct tmu_chain *chain = &pipe->chain;
    int32 has_alpha = pixel_bytes == 4;
    struct tmu_known known;

    plan->pipe = pipe;
    plan->planes = &iterations->planes;
    plan->last = 0;
    for (uint32 n = 0; n < chain->count; n++) {
        struct tmu_combining *combining = &plan->units[n].combining;
        const struct tmu_modes *modes = &chain->units[n]->modes;
        const int32 has_other = n + 1 < chain->count;

        plan->first = n;
        if (!is_passed(combining, modes, has_other, has_alpha)) {
            if (!find_sampling(&plan->units[n], chain->units[n], pipe->levels[n], iterations,
                               tmu_has_own(chain) ? n : 0))
                return 0;
            tmu_known_find(&known, modes, &plan->units[n].lod);
            tmu_combining_find(combining, modes, &known, has_other, has_alpha);
        }
        if (n == plan->last && tmu_shows(combining, TMU_TERM_OTHER))
            plan->last = n + 1;
        if (!(combining->reads & TMU_READS_OTHER))
            break;
        has_alpha = (combining->reads & TMU_READS_OTHER_ALPHA) != 0;
    }
    plan->is_direct = pixel_bytes == 2 && plan->units[plan->last].sample == tmu_bilinear
        && tmu_shows(&plan->units[plan->last].combining, TMU_TERM_LOCAL);
    return tmu_line_ready();
}
