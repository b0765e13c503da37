#include "screen/screen.h"

#include "limits.h"
#include "screen/copper.h"
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

/* Takes so many bytes of chip RAM, or keeps what there is. Returns 0 if memory is short. */
static int32 take_bytes(struct screen *screen, int32 bytes)
{
    if (screen->chip_bytes >= bytes)
        return 1;
    if (!mem_alloc(&screen->chip, bytes, MEMORY_CHIP))
        return 0;
    screen->chip_bytes = bytes;
    screen->blank = (uint16 *)screen->chip;
    copper_blank_make(screen->blank);
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

static void clear(uint8 *from, int32 bytes)
{
    uint32 *at = (uint32 *)from;

    for (; bytes > 0; bytes -= 4)
        *at++ = 0;
}

/* Divides the memory. Each part is at a multiple of the 8 bytes of a fetch. The blank list is not
   cleared: it may be on the screen. */
static void place(struct screen *screen)
{
    const struct screen_layout *layout = &screen->layout;
    uint8 *at = screen->chip + BLANK_LONGS * 4;

    clear(at, chip_needed(layout) - BLANK_LONGS * 4);
    clear(&screen->text[0][0], sizeof screen->text);
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

static void plan_make(const struct screen *screen, struct planar_plan *plan)
{
    plan->row_pitch = screen->layout.row_bytes;
    plan->plane_pitch = screen->layout.plane_bytes;
    plan->planes = screen->planes[screen->hidden];
}

/* Sets a plan's pixels; rows of `width` are made longer to a whole longword of each plane. */
static void plan_pixels(const struct screen *screen, struct planar_plan *plan, const struct frame *frame,
                        const uint8 *pixels, int32 width, int32 rows)
{
    const int32 whole = screen->layout.dots > 1 ? 15 : 31;

    plan->pixels = pixels;
    plan->pitch = frame->pitch;
    plan->width = screen->layout.ham ? width : (width + whole) & ~whole;
    plan->rows = rows;
}

void screen_finish(struct screen *screen)
{
    if (!screen->work.list)
        return;
    blits_end();
    screen->work.list = 0;
    screen_wait(screen);
}

/* Writes HAM8's planes 0 and 1, and the colour that each line begins with. */
static void make_ham(struct screen *screen)
{
    struct planar_plan plan;
    uint8 ground[4];

    screen->hidden = 0;
    plan_make(screen, &plan);
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

static void (*part_converter(const struct screen *screen))(const struct planar_plan *plan)
{
    return screen->layout.dots > 1 ? screen->merges_twice ? c2p_8_2x1_blits : c2p_8_2x1_blit
                                   : screen->merges_twice ? c2p_8_blits : c2p_8_blit;
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

void screen_close(struct screen *screen)
{
    if (!screen->is_open)
        return;
    screen_finish(screen);
    screen->is_open = 0;
    keys_close();
    display_close();
}

static int32 make(struct screen *screen, const struct screen_form *form)
{
    if (!display_has_aga())
        return outcome_lack(name, "needs AGA: an A1200 or A4000");
    if (!take_chip(screen, form->blitter) || (!screen->is_open && !take_machine(screen)))
        return 0;
    screen->convert = converter(&screen->layout, form->format);
    screen->merges_twice = 0;
    place(screen);
    for (int32 set = 0; set < 2; set++) {
        make_list(screen, set);
        screen->merged_twice[set] = 0;
        touched_begin(&screen->had[set], screen->layout.width, screen->layout.height);
        touched_fill(&screen->had[set]);        /* nothing is known of what is there */
    }
    if (screen->layout.ham)
        make_ham(screen);
    screen->hidden = screen->is_prepared = 0;
    display_show(screen->list[1]);
    screen->since = display_fields();
    return 1;
}

int32 screen_open(struct screen *screen, const struct screen_form *form)
{
    const char *why;

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

void screen_palette(struct screen *screen, const uint8 *palette)
{
    if (screen->layout.ham)
        return;
    screen_finish(screen);
    copper_palette_set(screen->palette[0], palette);
    copper_palette_set(screen->palette[1], palette);
}

/* Converts a box of a frame to `planes`. */
static void convert_box(const struct screen *screen, const struct frame *frame, const struct rectangle *box,
                        void (*convert)(const struct planar_plan *plan), uint8 *planes)
{
    const struct screen_layout *layout = &screen->layout;
    struct planar_plan plan;

    plan_make(screen, &plan);
    plan_pixels(screen, &plan, frame, frame->pixels + box->top * frame->pitch + box->left * frame->pixel_bytes,
                box->right - box->left, box->bottom - box->top);
    plan.planes = planes + box->top * layout->row_bytes + (box->left * layout->dots >> 3);
    convert(&plan);
}

/* Returns 1 if conversions can read the frame: their loops end where its rows do, in steps of 8 bytes. */
static int32 is_aligned(const struct frame *frame)
{
    return !(((uint32)frame->pixels | (uint32)frame->pitch) & 7);
}

int32 screen_convert_box(struct screen *screen, const struct frame *frame, int32 x, int32 y,
                         int32 width, int32 height)
{
    struct rectangle box;

    if (!is_aligned(frame))
        return 0;
    screen_finish(screen);
    box.left = x;
    box.top = y;
    box.right = x + width;
    box.bottom = y + height;
    touched_fill(&screen->had[screen->hidden]);
    convert_box(screen, frame, &box, screen->convert, screen->planes[screen->hidden]);
    return 1;
}

static void convert_touched(const struct screen *screen, const struct frame *frame, const struct touched *touched,
                            void (*convert)(const struct planar_plan *plan), uint8 *planes)
{
    struct rectangle box;

    for (touched_next(touched, 0, &box); box.top < box.bottom; touched_next(touched, box.bottom, &box))
        convert_box(screen, frame, &box, convert, planes);
}

int32 screen_prepare(struct screen *screen, const struct frame *frame, const struct touched *touched)
{
    struct touched *const had = &screen->had[screen->hidden];   /* in memory that the frame is converted to */
    const int32 is_merged = screen->between[0] != 0;

    if (!is_aligned(frame))
        return 0;
    if (!is_merged)
        screen_finish(screen);
    else if (screen->merged_twice[screen->hidden] != screen->merges_twice) {
        screen->merged_twice[screen->hidden] = screen->merges_twice;
        touched_fill(had);
    }
    if (touched)
        touched_join(had, touched);
    else
        touched_fill(had);
    if (is_merged)
        convert_touched(screen, frame, had, part_converter(screen), screen->between[screen->hidden]);
    else
        convert_touched(screen, frame, had, screen->convert, screen->planes[screen->hidden]);
    touched_box(had, &screen->prepared);
    if (touched)                /* the memory has this frame alone */
        touched_copy(had, touched);
    screen->is_prepared = is_merged;
    return 1;
}

/* Lets the blitter merge twice from the next frame on if it has rested for a field more than that takes, once if this frame
   waits for it. */
static void balance(struct screen *screen)
{
    const uint32 rest = 2 + (uint32)blits_bytes(&screen->layout) / MERGED_BYTES;

    if (!screen->work.list || !screen->merged)
        return;
    if (screen->work.left > 0)
        screen->merges_twice = 0;
    else if (display_fields() - display_since() >= rest)
        screen->merges_twice = 1;
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

int32 screen_show(struct screen *screen, const struct frame *frame, const struct touched *touched)
{
    if (!screen->between[0])
        screen_wait(screen);
    if (!screen_prepare(screen, frame, touched))
        return 0;
    screen_post(screen, 0);
    return 1;
}

int32 screen_convert(struct screen *screen, const struct frame *frame)
{
    return screen_convert_box(screen, frame, 0, 0, screen->layout.width, screen->layout.height);
}

void screen_swap(struct screen *screen)
{
    screen_finish(screen);
    display_show(screen->list[screen->hidden]);
    screen->hidden ^= 1;
}

void screen_post(struct screen *screen, uint32 field)
{
    field += screen->since;
    if (screen->is_prepared)
        blits_post(screen, field);
    else {
        screen_finish(screen);
        display_post(screen->list[screen->hidden], field);
    }
    screen->hidden ^= 1;
}

int32 screen_waits(const struct screen *screen)
{
    return display_shown() != (uint32)screen->list[screen->hidden ^ 1];
}

uint32 screen_wait(const struct screen *screen)
{
    for (uint32 field = display_fields(); screen_waits(screen); field = display_fields())
        display_wait(field);
    return display_since() - screen->since;
}

void screen_text(struct screen *screen, int32 line, const char *text)
{
    uint8 *at = screen->status + line * STATUS_LINE * STATUS_PITCH, *there = screen->text[line];

    for (int32 column = 0; column < STATUS_COLUMNS; column++, at++, there++) {
        const uint32 found = *text ? (uint32)(uint8)*text++ - FONT_FIRST : 0;
        const uint32 letter = found < FONT_LETTERS ? found : 0;
        const uint8 *row = screen->font + letter * FONT_ROWS;
        uint8 *to = at;

        if (*there == letter)           /* chip RAM is slow: write only what changed */
            continue;
        *there = (uint8)letter;
        for (int32 y = 0; y < FONT_ROWS; y++, to += STATUS_PITCH)
            *to = *row++;
    }
}

uint32 screen_fields(const struct screen *screen)
{
    return display_fields() - screen->since;
}
