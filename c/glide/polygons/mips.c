/* Lines whose pixels have several levels, without runs.

   Level n's coordinates are those of a finer level k shifted right by n - k, as floors nest: a line is
   divided once for all levels, by the finest one of the polygon, and once for units that share points. A unit's LODs are found once a line
   too, and each pixel's level is found with its texel. All bands are combined as the one whose
   fractions differ: what is known of the others' saves work, but changes no colour. */
#include "glide/polygons/plan.h"

enum {
    LEVEL_0 = 14                /* the shift from 14.18 to coordinates of level 0 */
};

static int32 multiplies(const struct glide_combination *by)
{
    return !by->zero_other || by->sub_local;
}

static int32 uses_fraction(const struct glide_combination *by)
{
    return !multiplies(by) || by->mselect == GLIDE_FACTOR_LOD_FRACTION;
}

static int32 is_combined_alike(const struct glide_band *a, const struct glide_band *b)
{
    return a->flip == b->flip && a->fraction == b->fraction && a->combining.rgb == b->combining.rgb
        && a->combining.alpha == b->combining.alpha && a->combining.alpha_way == b->combining.alpha_way;
}

/* Returns non-zero if all bands from part->band to part->last have the same filter and details, and
   are combined alike or by fractions. */
static int32 is_alike(struct glide_part *part)
{
    const struct glide_modes *modes = &part->glide->modes;
    const struct glide_band *first = &part->bands->of[part->band];
    int32 differ = 0;

    part->mixing = &first->combining;
    part->mixes = 0;
    for (uint32 n = part->band; n <= part->last; n++) {
        const struct glide_band *band = &part->bands->of[n];

        if (band->lod.filter != first->lod.filter || band->detail != first->detail
            || band->bits & GLIDE_DETAILS_DIFFER)
            return 0;
        differ |= !is_combined_alike(band, first);
        if (band->bits & GLIDE_FRACTIONS_DIFFER) {
            part->mixing = &band->combining;
            part->mixes = 1;
        }
    }
    if (!part->mixes)
        return !differ;
    return !modes->trilinear || (uses_fraction(&modes->rgb) && uses_fraction(&modes->alpha));
}

void glide_mips_open(struct glide_part *part)
{
    const struct glide_modes *modes = &part->glide->modes;

    part->mip_sample = 0;
    if (modes->fraction_bits != 4 || modes->clamp_s || modes->clamp_t || part->hides_behind
        || part->piece_bits || !is_alike(part) || !(part->mixing->reads & GLIDE_READS_LOCAL))
        part->mixing = 0;
}

static void open_passes(struct glide_part *part, uint32 finest)
{
    const struct plane *of = &part->iterations->planes.of[part->first];
    struct glide_steps *steps = &part->mip_steps;

    steps->s = (int32)of[GLIDE_S].dx;
    steps->t = (int32)of[GLIDE_T].dx;
    steps->w = (int32)of[GLIDE_W].dx;
    steps->shift = (uint16)(LEVEL_0 + finest);
    steps->half = 0;
    steps->last_s = steps->last_t = 0xffff;
    steps->behind = part->glide->modes.clamp_negative_w;
    glide_lods_open(part, &part->mip_lods);
}

/* Makes the table of levels, at the first line. Returns 0 if a level has no memory for quads. finest: the
   level of the line's coordinates. */
static int32 find_mips(struct glide_part *part, uint32 finest)
{
    const int32 linear = part->bands->of[part->band].lod.filter == GLIDE_BILINEAR;

    if (part->mip_sample)
        return 1;
    for (uint32 n = part->band; n <= part->last; n++) {
        const struct glide_band *band = &part->bands->of[n];
        const int32 end = n + 1 < part->bands->count ? band[1].lod.value - 1
            : glide_lod_most(&part->glide->modes);
        struct glide_sampling *from = &part->samplings[n];

        if (!from->level && !glide_sampling_find(part, n))
            return 0;
        if (from->sample != (linear ? glide_bilinear : glide_point))
            return 0;
        for (int32 k = band->lod.value >> 8; k <= end >> 8; k++) {
            struct glide_mip *to = &part->mips[k];

            to->half = ((uint32)from->steps.half << (band->lod.level - finest)) * 0x10001;
            to->mask_s = from->level->mask_s;
            to->mask_t = from->level->mask_t;
            to->texels = (int32)((linear ? (uint32)from->level->quads : (uint32)from->level->texels)
                                 - (uint32)to);
            to->columns_bits = from->level->columns_bits;
            to->shift = (uint16)(band->lod.level - finest);
        }
    }
    open_passes(part, finest);
    part->mip_sample = linear ? glide_bilinear_mips : glide_point_mips;
    return 1;
}

static int32 is_same_point(const struct glide_part *a, const struct glide_part *b)
{
    return b && a->first == b->first && a->coordinates == b->coordinates
        && a->mip_steps.behind == b->mip_steps.behind;
}

static int32 is_same_lod(const struct glide_part *a, const struct glide_part *b)
{
    const struct glide_modes *left = &a->glide->modes, *right = b ? &b->glide->modes : 0;

    return b && a->first == b->first && a->lod == b->lod && a->by_w == b->by_w
        && left->dither == right->dither && glide_lod_least(left) == glide_lod_least(right)
        && glide_lod_most(left) == glide_lod_most(right);
}

static void combine(const struct glide_part *part, const uint32 *other, uint32 *to, int32 count)
{
    const struct glide_band *band = &part->bands->of[part->band];
    struct glide_line_scratch *work = part->scratch;
    struct glide_factors factors;

    glide_factors_open(&factors, band);
    if (part->mixes) {
        factors.flip = 0;
        factors.fractions = (const uint8 *)work->lods + 1;
        factors.fraction_step = 2;
        if (part->glide->modes.trilinear) {
            glide_flips(work->lods, work->details, 0, count);
            factors.fractions = work->details;
            factors.fraction_step = 1;
        }
    }
    glide_combine_line(part->mixing, &part->glide->modes, &factors, work->texels, other, to, count);
}

/* Draws a line by a unit and those upstream. */
static void draw_part(struct glide_part *part, const struct glide_row *row, uint32 *to, int32 count)
{
    struct glide_part *before = part->mixing->reads & GLIDE_READS_OTHER ? part->upstream : 0;
    const int32 shows = glide_shows(part->mixing, GLIDE_TERM_LOCAL);
    struct glide_line_scratch *work = part->scratch;
    struct glide_iterators at;
    struct glide_mips mips;

    if (before)
        draw_part(before, row, work->other, count);
    glide_part_at(part, row->x, row->y, &at);
    if (!is_same_point(part, before))
        part->coordinates(&at, work->coordinates, &part->mip_steps, count);
    if (!is_same_lod(part, before)) {
        if (!part->by_w)
            at.w = 1 << 30;
        glide_lods_set(part, row, row->x, &part->mip_lods);
        glide_lod(&at, work->lods, &part->mip_lods, count);
    }
    mips.lods = work->lods;
    mips.levels = part->mips;
    part->mip_sample(work->coordinates, shows ? to : work->texels, &mips, count);
    if (!shows)
        combine(part, before ? work->other : 0, to, count);
}

/* Returns non-zero if a unit's pixels of a line are in more than one band, or in one whose fractions
   differ from pixel to pixel: both units then need what is found once here. */
static int32 is_varied(struct glide_part *part, const struct glide_row *row, int32 count)
{
    const uint32 step = part->iterations->planes.of[part->first + GLIDE_W].dx;
    const int32 dither = part->glide->modes.dither ? GLIDE_DITHERS - 1 : 0;
    uint32 near = 1 << 30, far = 1 << 30, band;
    struct glide_iterators at;

    if (part->by_w) {
        glide_part_at(part, row->x, row->y, &at);
        far = fix_magnitude(at.w);
        near = fix_magnitude((int32)((uint32)at.w + step * (uint32)(count - 1)));
    }
    band = glide_runs_band(part, dither, (int32)(near < far ? near : far));
    return ((dither || near != far) && part->bands->of[band].bits & GLIDE_FRACTIONS_DIFFER)
        || band != glide_runs_band(part, 0, (int32)(near < far ? far : near));
}

int32 glide_mips_draw(struct glide_plan *plan, const struct glide_row *row, uint32 *to, int32 count)
{
    struct glide_part *part = plan->parts;
    uint32 finest = GLIDE_LEVEL_LAST;

    while (!is_varied(part, row, count)) {
        part = part->upstream;
        if (!part)
            return 0;
    }
    for (part = plan->parts; part; part = part->upstream) {
        const uint32 level = part->bands->of[part->band].lod.level;

        finest = level < finest ? level : finest;
    }
    for (part = plan->parts; part; part = part->upstream)
        if (!find_mips(part, finest)) {
            plan->has_mips = 0;
            return 0;
        }
    draw_part(plan->parts, row, to, count);
    return 1;
}
