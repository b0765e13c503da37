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
    if (!work && !mem_alloc(&work, sizeof *work, MEMORY_ANY))
        work = 0;
    return work != 0;
}

/* What factors can be that are the same for all pixels. */
struct factors {
    uint8 none, detail, fraction;
};

enum { ALPHA = 3 };             /* of R G B A */

/* A channel's byte of texels, from pixel to pixel; the same for all; or 0, where there are none. */
static const uint8 *channel(const uint32 *texels, int32 number, int32 *step)
{
    *step = 4;
    return (const uint8 *)texels + number;
}

static const uint8 *constant(const uint8 *byte, int32 *step)
{
    *step = 0;
    return byte;
}

static const uint8 *channel_if(int32 is_there, const uint32 *texels, int32 number,
                               const struct factors *constants, int32 *step)
{
    return is_there ? channel(texels, number, step) : constant(&constants->none, step);
}

static const uint8 *factor(const struct tmu_combination *by, const struct factors *constants,
                           const uint32 *local, const uint32 *other, int32 number, int32 *step)
{
    switch (by->mselect) {
    case TMU_FACTOR_LOCAL: return channel(local, number, step);
    case TMU_FACTOR_OTHER_ALPHA: return channel_if(other != 0, other, ALPHA, constants, step);
    case TMU_FACTOR_LOCAL_ALPHA: return channel(local, ALPHA, step);
    case TMU_FACTOR_DETAIL: return constant(&constants->detail, step);
    case TMU_FACTOR_LOD_FRACTION: return constant(&constants->fraction, step);
    default: return constant(&constants->none, step);
    }
}

static const uint8 *added(const struct tmu_combination *by, const struct factors *constants,
                          const uint32 *local, int32 number, int32 *step)
{
    return channel_if(by->add_local || by->add_alpha_local, local,
                      by->add_alpha_local ? ALPHA : number, constants, step);
}

/* other: 0 where there is nothing upstream. */
static void combine(const struct tmu *tmu, const struct tmu_lod *lod, const uint32 *local,
                    const uint32 *other, uint32 *to, int32 count)
{
    const uint16 flip = tmu->modes.trilinear && lod->odd ? 255 : 0;
    struct factors constants;

    constants.none = 0;
    constants.detail = (uint8)tmu_detail_factor(&tmu->modes, lod->value);
    constants.fraction = (uint8)lod->value;
    for (int32 number = 0; number < 4; number++) {
        const struct tmu_combination *by = number == ALPHA ? &tmu->modes.alpha : &tmu->modes.rgb;
        struct tmu_inputs in;

        in.other = channel_if(other && !by->zero_other, other, number, &constants,
                              &in.other_step);
        in.local = channel_if(by->sub_local, local, number, &constants, &in.local_step);
        in.factor = factor(by, &constants, local, other, number, &in.factor_step);
        in.added = added(by, &constants, local, number, &in.added_step);
        in.flip = (uint16)(flip ^ (by->reverse ? 0 : 255));
        in.invert = by->invert ? 255 : 0;
        tmu_combiner(0, (uint8 *)to + number, &in, count);
    }
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

    if (plan->is_direct && frame->pixel_bytes == 2) {
        find_coordinates(plan, &plan->units[0], x, y, count);
        tmu_bilinear_565(work->coordinates, pixels, plan->units[0].level, count);
        return;
    }
    for (uint32 n = plan->first + 1; n--; other = work->other) {
        const struct tmu_sampling *from = &plan->units[n];
        uint32 *to = n ? work->other : colours;

        find_coordinates(plan, from, x, y, count);
        from->sample(work->coordinates, from->combines ? work->texels : to, from->level, count);
        if (from->combines)
            combine(plan->pipe->chain.units[n], &from->lod, work->texels, other, to, count);
    }
    if (frame->pixel_bytes == 2)
        tmu_store_565(colours, pixels, 0, count);
}
