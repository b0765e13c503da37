/* The machine's screen, taken over: copper lists, and the blitter's part. */
#include "limits.h"
#include "screen/copper.h"
#include "screen/screen.h"
#include "screen/ways.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

/* Bytes of half planes that the blitter merges in a field: 81,920 in some 598,000 cycles, of which a field has 283,750. */
enum { MERGED_BYTES = 38900 };

static const char name[] = "screen";

/* Returns the bytes of chip RAM for both sets of planes, the copper lists and the status plane. In
   HAM8 both sets share planes 0 and 1. */
static int32 chip_needed(const struct screen_layout *layout)
{
    const int32 planes = layout->ham ? 2 * PLANES - 2 : 2 * PLANES;

    return planes * layout->plane_bytes + (2 * COPPER_LONGS + BLANK_LONGS) * 4
        + STATUS_ROWS * STATUS_PITCH;
}

/* The same, with the blank list at its beginning. */
static int32 take_bytes(struct screen *screen, int32 bytes)
{
    if (!screen_take_chip(screen, bytes))
        return 0;
    screen->blank = (uint16 *)screen->chip;
    copper_blank_make(screen->blank);   /* the same words, if it is on the screen */
    return 1;
}

static int32 take_chip(struct screen *screen, uint32 blitter)
{
    const int32 bytes = chip_needed(&screen->layout), part = blits_bytes(&screen->layout);

    screen->between[0] = screen->between[1] = screen->merged = 0;
    if (blitter && !screen->layout.ham) {
        if (take_bytes(screen, bytes + 3 * part))
            screen->merged = screen->chip + bytes + 2 * part;
        if (screen->merged || take_bytes(screen, bytes + 2 * part)) {
            screen->between[0] = screen->chip + bytes;
            screen->between[1] = screen->between[0] + part;
        }
    }
    return screen->between[0] || take_bytes(screen, bytes) || outcome_lack_memory(name, "planes and copper lists");
}

/* Divides the memory. Each part is at a multiple of the 8 bytes of a fetch. The blank list is not
   cleared: it may be on the screen. */
static void place(struct screen *screen)
{
    const struct screen_layout *layout = &screen->layout;
    uint8 *at = screen->chip + BLANK_LONGS * 4;

    screen_clear(at, chip_needed(layout) - BLANK_LONGS * 4);
    screen->status = at;
    at += STATUS_ROWS * STATUS_PITCH;
    for (int32 set = 0; set < 2; set++) {
        screen->list[set] = (uint16 *)at;
        at += COPPER_LONGS * 4;
    }
    screen->planes[0] = at;
    screen->planes[1] = at + (layout->ham ? PLANES - 2 : PLANES) * layout->plane_bytes;
}

static void make_list(struct screen *screen, int32 set)
{
    const int32 bytes = screen->layout.plane_bytes;
    struct copper_planes planes;

    for (int32 plane = 0; plane < PLANES; plane++)
        planes.plane[plane] = screen->planes[screen->layout.ham && plane < 2 ? 0 : set]
            + plane * bytes;
    planes.status = screen->status;
    screen->palette[set] = copper_list_make(screen->list[set], &screen->layout, &planes);
}

static void finish(struct screen *screen)
{
    blits_end();
    screen->work.list = 0;
    screen_wait(screen);
}

/* Writes HAM8's planes 0 and 1, and the colour that each line begins with. */
static void make_ham(struct screen *screen)
{
    struct planar_plan plan;
    uint8 ground[4];

    screen_plan(screen, &plan);
    plan.width = screen->layout.width;
    plan.rows = screen->layout.height;
    ham8_control(&plan);
    ground[0] = 0;
    ground[1] = ground[2] = ground[3] = 2;
    for (int32 set = 0; set < 2; set++)
        copper_colour_set(screen->palette[set], 0, ground);
}

static void (*converter(const struct screen_layout *layout, uint32 format))(const struct planar_plan *plan)
{
    return format == PIXEL_CHUNKY ? layout->dots > 1 ? c2p_8_2x1 : c2p_8
         : format == PIXEL_RGB565 ? c2p_ham8_16
         : format == PIXEL_RGBA5551 ? c2p_ham8_5551 : c2p_ham8_32;
}

static void merge_twice(struct screen *screen, int32 is_twice)
{
    screen->merges_twice = is_twice;
    screen->convert_part = screen->layout.dots > 1 ? is_twice ? c2p_8_2x1_blits : c2p_8_2x1_blit
                                                   : is_twice ? c2p_8_blits : c2p_8_blit;
}

static int32 take_machine(struct screen *screen)
{
    if (!font_read(screen->font))
        return outcome_lack(name, "the ROM has no font");
    if (!display_open(screen->blank))
        return outcome_lack(name, "the display cannot be taken");
    screen->is_open = 1;
    return keys_open() || outcome_lack(name, "the keys cannot be taken");
}

static void give_back(struct screen *screen)
{
    screen->is_prepared = 0;
    keys_close();
    display_close();
}

/* Lets the blitter merge twice from the next frame on if it has rested for a field more than that takes, once if this frame
   waits for it. */
static void balance(struct screen *screen)
{
    const uint32 rest = 2 + (uint32)blits_bytes(&screen->layout) / MERGED_BYTES;

    if (!screen->work.list || !screen->merged)
        return;
    if (screen->work.left > 0)
        merge_twice(screen, 0);
    else if (display_fields() - display_since() >= rest)
        merge_twice(screen, 1);
}

/* Starts the blits of what was prepared; waits until the frame before is shown. */
static void blits_post(struct screen *screen, uint32 field)
{
    const struct rectangle *const box = &screen->prepared;
    struct blit_list *const work = &screen->work;

    balance(screen);
    screen_finish(screen);
    screen_wait(screen);
    screen->is_prepared = 0;
    if (box->top == box->bottom) {
        display_post(screen->list[screen->hidden], field);
        return;
    }
    work->next = screen->blits;
    work->left = blits_make(screen->blits, &screen->layout, screen->between[screen->hidden],
                            screen->merged_twice[screen->hidden] ? screen->merged : 0,
                            screen->planes[screen->hidden], box->top, box->bottom - box->top);
    work->list = screen->list[screen->hidden];
    work->field = field;
    blits_start(work);
}

static void post(struct screen *screen, uint32 field)
{
    field += screen->since;
    if (screen->is_prepared)
        blits_post(screen, field);
    else {
        screen_finish(screen);
        display_post(screen->list[screen->hidden], field);
    }
}

static int32 waits(const struct screen *screen)
{
    return display_shown() != (uint32)screen->list[screen->hidden ^ 1];
}

static uint32 wait(const struct screen *screen)
{
    for (uint32 field = display_fields(); waits(screen); field = display_fields())
        display_wait(field);
    return display_since() - screen->since;
}

static uint32 fields(const struct screen *screen)
{
    return display_fields() - screen->since;
}

static uint32 key(const struct screen *screen)
{
    return screen->is_open ? key_take() : NO_KEY;
}

static void set_palette(struct screen *screen, const uint8 *palette)
{
    copper_palette_set(screen->palette[0], palette);
    copper_palette_set(screen->palette[1], palette);
}

static const struct screen_ways machine = {set_palette, post, waits, wait, fields, key, finish, give_back};

static int32 make(struct screen *screen, const struct screen_form *form)
{
    if (!display_has_aga())
        return outcome_lack(name, "needs AGA: an A1200 or A4000");
    if (!take_chip(screen, form->blitter) || (!screen->is_open && !take_machine(screen)))
        return 0;
    screen->convert = converter(&screen->layout, form->format);
    screen->rows_twice = 0;     /* the display shows them twice */
    merge_twice(screen, 0);
    place(screen);
    screen_begin(screen, &machine);
    for (int32 set = 0; set < 2; set++) {
        make_list(screen, set);
        screen->merged_twice[set] = 0;
    }
    if (screen->layout.ham)
        make_ham(screen);
    display_show(screen->list[1]);
    screen->since = display_fields();
    return 1;
}

int32 screen_open(struct screen *screen, const struct screen_form *form)
{
    const char *why;

    if (screen->is_open && screen->ways != &machine)
        screen_close(screen);
    if (screen->is_open) {
        screen_finish(screen);
        display_show(screen->blank);
    }
    why = screen_layout_find(&screen->layout, form);
    if (why ? text_refuse(name, why) : make(screen, form))
        return 1;
    screen_close(screen);
    return 0;
}

