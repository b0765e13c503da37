/* The combine unit over a line: by the pass that does just what is asked. */
#include "tmu/plan.h"

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

enum { ALPHA = 3 };             /* of R G B A */

static const uint8 none = 0;

static void set_factor(struct bytes *bytes, const struct tmu_combination *by,
                       const struct tmu_factors *factors, const uint32 *local, const uint32 *other,
                       int32 number)
{
    set_constant(bytes, &none);
    switch (by->mselect) {
    case TMU_FACTOR_LOCAL: set_channel(bytes, local, number); break;
    case TMU_FACTOR_OTHER_ALPHA:
        if (other)
            set_channel(bytes, other, ALPHA);
        break;
    case TMU_FACTOR_LOCAL_ALPHA: set_channel(bytes, local, ALPHA); break;
    case TMU_FACTOR_DETAIL:
        bytes->at = factors->details;
        bytes->step = factors->detail_step;
        break;
    case TMU_FACTOR_LOD_FRACTION:
        bytes->at = factors->fractions;
        bytes->step = factors->fraction_step;
        break;
    }
}

static void set_added(struct bytes *bytes, const struct tmu_combination *by, const uint32 *local,
                      int32 number)
{
    if (by->add_alpha_local || (number == ALPHA && by->add_local))
        set_channel(bytes, local, ALPHA);
    else if (by->add_local)
        set_channel(bytes, local, number);
    else
        set_constant(bytes, &none);
}

void tmu_combine_line(const struct tmu *tmu, const struct tmu_factors *factors,
                      const uint32 *local, const uint32 *other, uint32 *to, int32 count)
{
    for (int32 number = 0; number < 4; number++) {
        const struct tmu_combination *by = number == ALPHA ? &tmu->modes.alpha : &tmu->modes.rgb;
        struct bytes from, less, m, plus;
        struct tmu_inputs inputs;

        set_constant(&from, &none);
        set_constant(&less, &none);
        if (!by->zero_other && other)
            set_channel(&from, other, number);
        if (by->sub_local)
            set_channel(&less, local, number);
        set_factor(&m, by, factors, local, other, number);
        set_added(&plus, by, local, number);
        inputs.other = from.at;
        inputs.other_step = from.step;
        inputs.local = less.at;
        inputs.local_step = less.step;
        inputs.factor = m.at;
        inputs.factor_step = m.step;
        inputs.added = plus.at;
        inputs.added_step = plus.step;
        inputs.flip = (uint16)(factors->flip ^ (by->reverse ? 0 : 255));
        inputs.invert = by->invert ? 255 : 0;
        tmu_combiner(0, (uint8 *)to + number, &inputs, count);
    }
}
