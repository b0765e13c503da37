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

/* The bytes of a channel, texels from pixel to pixel, or one for all. */
struct bytes {
    const uint8 *at;
    int32 step;
};

static void set_constant(struct bytes *bytes, const uint8 *byte)
{
    bytes->at = byte;
    bytes->step = 0;
}

static void set_channel(struct bytes *bytes, const uint32 *texels, int32 number)
{
    bytes->at = (const uint8 *)texels + number;
    bytes->step = 4;
}

/* What factors can be that are the same for all pixels. */
struct factors {
    uint8 none, detail, fraction;
};

enum { ALPHA = 3 };             /* of R G B A */

static void set_factor(struct bytes *bytes, const struct tmu_combination *by,
                       const struct factors *constants, const uint32 *local, const uint32 *other,
                       int32 number)
{
    set_constant(bytes, &constants->none);
    switch (by->mselect) {
    case TMU_FACTOR_LOCAL: set_channel(bytes, local, number); break;
    case TMU_FACTOR_OTHER_ALPHA:
        if (other)
            set_channel(bytes, other, ALPHA);
        break;
    case TMU_FACTOR_LOCAL_ALPHA: set_channel(bytes, local, ALPHA); break;
    case TMU_FACTOR_DETAIL: set_constant(bytes, &constants->detail); break;
    case TMU_FACTOR_LOD_FRACTION: set_constant(bytes, &constants->fraction); break;
    }
}

static void set_added(struct bytes *bytes, const struct tmu_combination *by,
                      const struct factors *constants, const uint32 *local, int32 number)
{
    if (by->add_alpha_local || (number == ALPHA && by->add_local))
        set_channel(bytes, local, ALPHA);
    else if (by->add_local)
        set_channel(bytes, local, number);
    else
        set_constant(bytes, &constants->none);
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
        struct bytes from, less, m, plus;
        struct tmu_inputs inputs;

        set_constant(&from, &constants.none);
        set_constant(&less, &constants.none);
        if (!by->zero_other && other)
            set_channel(&from, other, number);
        if (by->sub_local)
            set_channel(&less, local, number);
        set_factor(&m, by, &constants, local, other, number);
        set_added(&plus, by, &constants, local, number);
        inputs.other = from.at;
        inputs.other_step = from.step;
        inputs.local = less.at;
        inputs.local_step = less.step;
        inputs.factor = m.at;
        inputs.factor_step = m.step;
        inputs.added = plus.at;
        inputs.added_step = plus.step;
        inputs.flip = (uint16)(flip ^ (by->reverse ? 0 : 255));
        inputs.invert = by->invert ? 255 : 0;
        tmu_combiner(0, (uint8 *)to + number, &inputs, count);
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
