#include "screen/screen.h"

#include "screen/ways.h"
#include "system/system.h"

void screen_clear(uint8 *from, int32 bytes)
{
    uint32 *at = (uint32 *)from;

    for (; bytes > 0; bytes -= 4)
        *at++ = 0;
}

int32 screen_take_chip(struct screen *screen, int32 bytes)
{
    if (screen->chip_bytes >= bytes)
        return 1;
    if (!mem_alloc(&screen->chip, bytes, MEMORY_CHIP))
        return 0;
    screen->chip_bytes = bytes;
    return 1;
}

void screen_begin(struct screen *screen, const struct screen_ways *ways)
{
    screen->ways = ways;
    screen->hidden = screen->is_prepared = 0;
    for (int32 set = 0; set < 2; set++) {
        touched_begin(&screen->had[set], screen->layout.width, screen->layout.height);
        touched_fill(&screen->had[set]);        /* nothing is known of what is there */
    }
    screen_clear(&screen->text[0][0], sizeof screen->text);
}

void screen_close(struct screen *screen)
{
    if (!screen->is_open)
        return;
    screen_finish(screen);
    screen->is_open = 0;
    screen->ways->close(screen);
}

void screen_finish(struct screen *screen)
{
    if (screen->work.list)
        screen->ways->finish(screen);
}

void screen_palette(struct screen *screen, const uint8 *palette)
{
    if (screen->layout.ham)
        return;
    screen_finish(screen);
    screen->ways->palette(screen, palette);
}

void screen_plan(const struct screen *screen, struct planar_plan *plan)
{
    plan->row_pitch = screen->layout.row_bytes << screen->rows_twice;
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

/* Converts a box of a frame to `planes`. */
static void convert_box(const struct screen *screen, const struct frame *frame, const struct rectangle *box,
                        void (*convert)(const struct planar_plan *plan), uint8 *planes)
{
    const struct screen_layout *layout = &screen->layout;
    struct planar_plan plan;

    screen_plan(screen, &plan);
    plan_pixels(screen, &plan, frame, frame->pixels + box->top * frame->pitch + box->left * frame->pixel_bytes,
                box->right - box->left, box->bottom - box->top);
    planes += box->top * plan.row_pitch + (box->left * layout->dots >> 3);
    plan.planes = planes;
    convert(&plan);
    if (screen->rows_twice) {
        plan.planes = planes + layout->row_bytes;
        convert(&plan);
    }
}

/* Returns 1 if conversions can read the frame: it has the screen's size, and their loops end where its rows do, in steps
   of 8 bytes. */
static int32 is_fit(const struct screen *screen, const struct frame *frame)
{
    return !(((uint32)frame->pixels | (uint32)frame->pitch) & 7) && frame->width == screen->layout.width
        && frame->height == screen->layout.height;
}

int32 screen_convert_box(struct screen *screen, const struct frame *frame, int32 x, int32 y,
                         int32 width, int32 height)
{
    struct rectangle box;

    if (!is_fit(screen, frame))
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

int32 screen_convert(struct screen *screen, const struct frame *frame)
{
    return screen_convert_box(screen, frame, 0, 0, screen->layout.width, screen->layout.height);
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

    if (!is_fit(screen, frame))
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
        convert_touched(screen, frame, had, screen->convert_part, screen->between[screen->hidden]);
    else
        convert_touched(screen, frame, had, screen->convert, screen->planes[screen->hidden]);
    touched_box(had, &screen->prepared);
    if (touched)                /* the memory has this frame alone */
        touched_copy(had, touched);
    screen->is_prepared = is_merged;
    return 1;
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

void screen_swap(struct screen *screen)
{
    screen_finish(screen);
    screen_post(screen, 0);
    screen_wait(screen);
}

void screen_post(struct screen *screen, uint32 field)
{
    screen->ways->post(screen, field);
    screen->hidden ^= screen->planes[0] != screen->planes[1];
}

int32 screen_waits(const struct screen *screen)
{
    return screen->ways->waits(screen);
}

uint32 screen_wait(const struct screen *screen)
{
    return screen->ways->wait(screen);
}

uint32 screen_fields(const struct screen *screen)
{
    return screen->ways->fields(screen);
}

uint32 screen_key(const struct screen *screen)
{
    return screen->ways->key(screen);
}

void screen_text(struct screen *screen, int32 line, const char *text)
{
    uint8 *at = screen->status + line * STATUS_LINE * STATUS_PITCH, *there = screen->text[line];

    if (!screen->status)
        return;
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
