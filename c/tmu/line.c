/* A line of a polygon, pass by pass. */
#include "system/system.h"
#include "tmu/plan.h"

/* What stands between the passes of a line. */
struct work {
    uint32 coordinates[SCENE_SIDE_MAX];
    uint32 texels[SCENE_SIDE_MAX], other[SCENE_SIDE_MAX], colours[SCENE_SIDE_MAX];
};

static struct work *work;

int32 tmu_line_ready(void)
{
    if (!work && !mem_take(&work, sizeof *work, MEMORY_ANY))
        work = 0;
    return work != 0;
}

/* other: 0 where there is nothing upstream. */
static void combine(const struct tmu_sampling *from, const struct tmu *tmu, const uint32 *other,
                    uint32 *to, int32 count)
{
    const struct tmu_lod *lod = &from->lod;
    const uint8 detail = (uint8)tmu_detail_factor(&tmu->modes, lod->value);
    const uint8 fraction = (uint8)lod->value;
    struct tmu_factors factors;

    factors.details = &detail;
    factors.fractions = &fraction;
    factors.detail_step = factors.fraction_step = 0;
    factors.flip = tmu->modes.trilinear && lod->odd ? 255 : 0;
    tmu_combine_line(&from->combining, &tmu->modes, &factors, work->texels, other, to, count);
}

static void find_coordinates(const struct tmu_plan *plan, const struct tmu_sampling *from, int32 x,
                             int32 y, int32 count)
{
    struct tmu_iterators at;

    at.s = (int32)planes_at(plan->planes, from->first + TMU_S, x, y);
    at.t = (int32)planes_at(plan->planes, from->first + TMU_T, x, y);
    at.w = (int32)planes_at(plan->planes, from->first + TMU_W, x, y);
    from->coordinates(&at, work->coordinates, &from->steps, count);
}

void tmu_plan_draw(const struct tmu_plan *plan, const struct frame *frame, int32 x, int32 y,
                   int32 count)
{
    uint8 *pixels = frame->pixels + y * frame->pitch + x * frame->pixel_bytes;
    uint32 *colours = frame->pixel_bytes == 4 ? (uint32 *)pixels : work->colours;
    const uint32 *other = 0;

    if (plan->is_direct) {
        find_coordinates(plan, &plan->units[plan->last], x, y, count);
        tmu_bilinear_565(work->coordinates, pixels, plan->units[plan->last].level, count);
        return;
    }
    for (uint32 n = plan->first + 1; n-- > plan->last; other = work->other) {
        const struct tmu_sampling *from = &plan->units[n];
        uint32 *to = n > plan->last ? work->other : colours;
        const int32 is_local = tmu_shows(&from->combining, TMU_TERM_LOCAL);

        if (from->combining.reads & TMU_READS_LOCAL) {
            find_coordinates(plan, from, x, y, count);
            from->sample(work->coordinates, is_local ? to : work->texels, from->level, count);
        }
        if (!is_local)
            combine(from, plan->pipe->chain.units[n], other, to, count);
    }
    if (frame->pixel_bytes == 2)
        tmu_store_565(colours, pixels, 0, count);
}
