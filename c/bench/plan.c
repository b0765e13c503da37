#include "bench/plan.h"

#include "system/file.h"
#include "system/system.h"
#include "system/text.h"

/* Twice the sum of all partial sums, less the last one, gives the odd factors. */
uint32 plan_checksum(const uint32 *from, uint32 longs)
{
    uint32 sum = 0, sums = 0;

    for (; longs; longs--) {
        sum += *from++;
        sums += sum;
    }
    return 2 * sums - sum;
}

uint32 plan_pieces(uint32 bytes)
{
    return bytes / PLAN_PIECE + (bytes % PLAN_PIECE != 0);
}

const struct plan_case *plan_cases(const uint8 *plan)
{
    return (const struct plan_case *)(plan + ((const struct plan_header *)plan)->cases_at);
}

static int32 usable(const uint8 *plan, uint32 bytes, const char *name)
{
    const struct plan_header *h = (const struct plan_header *)plan;
    const uint32 summed = (uint32)((const uint8 *)&h->cases - plan);

    if (bytes < sizeof *h)
        return text_refuse(name, "not a usable plan file: size");
    if (h->magic != PLAN_MAGIC)
        return text_refuse(name, "not a usable plan file: magic");
    if (h->version != PLAN_VERSION)
        return text_refuse(name, "not a usable plan file: version");
    if (h->size != bytes || bytes & 3)
        return text_refuse(name, "not a usable plan file: size");
    if (h->checksum != plan_checksum((const uint32 *)(plan + summed), (bytes - summed) / 4))
        return text_refuse(name, "not a usable plan file: checksum");
    if (!table_inside(h->cases_at, h->cases, sizeof(struct plan_case), bytes))
        return text_refuse(name, "not a usable plan file: cases_at");
    return 1;
}

/* Every piece that an image's list names must be in the file. */
static int32 usable_image(const uint8 *plan, uint32 at, uint32 image, uint32 bytes)
{
    const uint32 *piece = (const uint32 *)(plan + at);

    if (image & 3 || !table_inside(at, plan_pieces(image), 4, bytes))
        return 0;
    for (uint32 size; image; image -= size, piece++) {
        size = image < PLAN_PIECE ? image : PLAN_PIECE;
        if (*piece > PLAN_WRITTEN && !table_inside(*piece & ~(uint32)PLAN_WRITTEN, size, 1, bytes))
            return 0;
    }
    return 1;
}

/* Every offset of the list must leave room for a longword in `near`. */
static int32 usable_offsets(const uint8 *plan, uint32 at, uint32 count, uint32 near, uint32 bytes)
{
    if (!table_inside(at, count, 4, bytes))
        return 0;
    for (const uint32 *offset = (const uint32 *)(plan + at); count; count--, offset++)
        if (*offset & 1 || near < 4 || *offset > near - 4)
            return 0;
    return 1;
}

static int32 text_ends(const uint8 *plan, uint32 at, uint32 bytes)
{
    while (at < bytes && plan[at])
        at++;
    return at < bytes;
}

/* Returns the name of the first field of a case that is wrong, or 0. */
static const char *wrong_case(const struct plan_case *c, const uint8 *plan, uint32 bytes)
{
    if (!text_ends(plan, c->name_at, bytes))
        return "name_at";
    if (!usable_image(plan, c->near_at, c->near, bytes))
        return "near";
    if (!usable_image(plan, c->far_at, c->far, bytes))
        return "far";
    if (c->far_memory != MEMORY_ANY && c->far_memory != MEMORY_CHIP)
        return "far_memory";
    if (!usable_offsets(plan, c->near_offsets_at, c->near_offsets, c->near, bytes))
        return "near_offsets";
    if (!usable_offsets(plan, c->far_offsets_at, c->far_offsets, c->near, bytes))
        return "far_offsets";
    if (c->display >= DISPLAY_MODES)
        return "display";
    if (c->limit < 1 || c->limit > 65535)
        return "limit";
    if (!text_ends(plan, c->title_at, bytes))
        return "title_at";
    if ((c->chip || c->fast) && (!c->units || !c->repeats))
        return "units";
    return 0;
}

static int32 usable_cases(const uint8 *plan, uint32 bytes, const char *name)
{
    const struct plan_case *cases = plan_cases(plan);
    uint32 count = ((const struct plan_header *)plan)->cases;

    for (uint32 i = 0; i < count; i++) {
        const char *wrong = wrong_case(&cases[i], plan, bytes);

        if (wrong) {
            text_add(name);
            text_add(": not a usable plan file: case ");
            text_number((int32)i);
            return text_refuse("", wrong);
        }
    }
    return 1;
}

int32 plan_load(const char *name, const uint8 **plan)
{
    uint8 *data;
    uint32 bytes;

    if (!file_load(name, &data, &bytes))
        return 0;
    *plan = data;
    return usable(data, bytes, name) && usable_cases(data, bytes, name);
}
