#include "screen/intuition.h"

#include "limits.h"
#include "screen/screen.h"
#include "screen/ways.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

static const char name[] = "screen";

static void palette(struct screen *screen, const uint8 *from)
{
    struct intuition_colours colours;

    colours.count = INTUITION_COLOURS;
    colours.end = 0;
    for (uint32 first = 0; first < 256; first += INTUITION_COLOURS) {
        colours.first = (uint16)first;
        for (int32 i = 0; i < 3 * INTUITION_COLOURS; i += 3, from += 4)
            for (int32 part = 0; part < 3; part++)
                colours.part[i + part] = from[1 + part] * 0x01010101u;
        intuition_colours_set(screen->intuition, &colours);
    }
}

/* Asks for the bitmap in the field before the one that it is posted for. */
static void post(struct screen *screen, uint32 field)
{
    struct intuition *const of = screen->intuition;

    while ((int32)(field - of->fields) > 1)
        intuition_field(of);
    intuition_show(of, screen->hidden);
}

static int32 waits(const struct screen *screen)
{
    return intuition_waits(screen->intuition);
}

static uint32 wait(const struct screen *screen)
{
    intuition_wait(screen->intuition);
    return screen->intuition->since;
}

static uint32 fields(const struct screen *screen)
{
    return screen->intuition->fields;
}

static uint32 key(const struct screen *screen)
{
    return intuition_key(screen->intuition);
}

static void finish(struct screen *screen)
{
    screen->work.list = 0;      /* no blits */
}

static void give_back(struct screen *screen)
{
    intuition_close(screen->intuition);
}

static const struct screen_ways ways = {palette, post, waits, wait, fields, key, finish, give_back};

/* Returns the distance of a bitmap's planes; 0 if the conversions cannot write them: their distances are equal, and all
   are multiples of 4. */
static int32 plane_distance(const struct bitmap *bitmap)
{
    const int32 distance = bitmap->plane[1] - bitmap->plane[0];

    if (((uint32)bitmap->plane[0] | (uint32)distance | bitmap->row_bytes) & 3)
        return 0;
    for (int32 plane = 2; plane < INTUITION_PLANES; plane++)
        if (bitmap->plane[plane] - bitmap->plane[plane - 1] != distance)
            return 0;
    return distance;
}

/* Sets where the picture is in the bitmaps; its left side is that of a longword of each plane. Returns 0 if their planes
   are not what conversions write. */
static int32 place(struct screen *screen)
{
    const struct intuition *const of = screen->intuition;
    struct screen_layout *const layout = &screen->layout;

    layout->left &= ~31;
    layout->row_bytes = of->bitmap[0]->row_bytes;
    layout->plane_bytes = plane_distance(of->bitmap[0]);
    for (int32 set = 0; set < 2; set++) {
        const struct bitmap *const bitmap = of->bitmap[set];

        if (!layout->plane_bytes || bitmap->row_bytes != layout->row_bytes
            || plane_distance(bitmap) != layout->plane_bytes)
            return 0;
        screen->planes[set] = bitmap->plane[0] + layout->top * layout->row_bytes + layout->left / 8;
        for (int32 plane = 0; plane < INTUITION_PLANES; plane++)
            for (int32 row = 0; row < SCREEN_HEIGHT; row++)
                screen_clear(bitmap->plane[plane] + row * layout->row_bytes, SCREEN_WIDTH / 8);
    }
    return 1;
}

static int32 make(struct screen *screen)
{
    if (!screen_take_chip(screen, POINTER_BYTES)
        || (!screen->intuition && !mem_alloc(&screen->intuition, sizeof *screen->intuition, MEMORY_ANY)))
        return outcome_lack_memory(name, "a screen of Intuition's");
    screen_clear(screen->chip, POINTER_BYTES);
    screen_clear((uint8 *)screen->intuition, sizeof *screen->intuition);
    screen->intuition->pointer = (uint16 *)screen->chip;
    if (!intuition_open(screen->intuition))
        return outcome_lack(name, "Intuition opens none of 8 planes: that takes Kickstart 3.0, AGA, and chip RAM");
    screen->is_open = 1;
    screen->convert = screen->layout.dots > 1 ? c2p_8_2x1 : c2p_8;
    screen->rows_twice = screen->layout.twice;
    screen->between[0] = screen->between[1] = screen->merged = 0;
    screen->status = 0;
    screen_begin(screen, &ways);
    if (!place(screen)) {
        screen_close(screen);
        return outcome_lack(name, "the planes of Intuition's bitmaps are not at equal distances");
    }
    screen->hidden = screen->planes[0] != screen->planes[1];    /* the screen was opened with the first */
    return 1;
}

int32 screen_open_intuition(struct screen *screen, const struct screen_form *form)
{
    const char *why = screen_layout_find(&screen->layout, form);

    screen_close(screen);
    if (!why && screen->layout.ham)
        why = "Intuition's screens show chunky frames alone";
    return why ? text_refuse(name, why) : make(screen);
}
