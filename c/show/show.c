#include "show/show.h"

#include "scene/coarse.h"
#include "scene/load.h"
#include "system/machine.h"
#include "system/outcome.h"
#include "system/system.h"

#define NO_LIMIT 65535          /* of the clock: the watchdog is off */
#define MEASURE_REST 4          /* the pause after measuring, in times that it took */
#define READ_BEYOND 32          /* bytes after a frame that its conversion may read */

static void set_size(struct frame *frame, const struct scene_header *header)
{
    frame->width = header->width;
    frame->height = header->height;
    frame->pixel_bytes = scene_pixel_bytes(header->format);
    frame->pitch = frame->width * frame->pixel_bytes;
}

static int32 make_frame(struct frame *frame, const struct scene_header *header)
{
    uint8 *pixels;

    set_size(frame, header);
    frame->pixels = 0;
    if (!mem_alloc(&pixels, frame->pitch * frame->height + READ_BEYOND, MEMORY_ANY))
        return 0;
    frame->pixels = pixels;
    return 1;
}

void show_set(struct show *s)
{
    s->has_tables = settings_set(&s->scene, &s->settings);
    measured_clear(&s->measured);
    s->next_measuring = 0;
}

void show_draw(struct show *s)
{
    enum polygon_result result;

    s->asked = s->scene.header->cleared ? touched_ask(&s->touched) : 0;
    clock_start(NO_LIMIT);
    result = scene_draw_over(&s->renderer, &s->scene, s->number, s->asked);
    s->ticks = clock_stop();
    if (result != POLYGON_DRAWN)
        s->refused = result;
}

static void compare(struct show *s)
{
    const int32 is_coarse = s->scene.is_coarse;

    settings_set_exact(&s->scene);
    scene_set_coarse(&s->scene, 0);
    s->renderer.frame = &s->exact;
    scene_draw(&s->renderer, &s->scene, s->number);
    s->renderer.frame = &s->frame;
    scene_set_coarse(&s->scene, is_coarse);
    settings_set(&s->scene, &s->settings);
    measured_compare(&s->measured, &s->frame, &s->exact);
}

void show_measure(struct show *s)
{
    const uint32 began = screen_fields(&s->screen);
    uint32 took;

    if (measured_has_room(&s->measured)) {
        counts_frame(&s->counts, &s->renderer, &s->scene, s->number);
        measured_add(&s->measured, &s->counts, s->ticks);
        if (s->exact.pixels)
            compare(s);
    }
    took = screen_fields(&s->screen) - began;
    s->rate.spent += took;
    s->next_measuring = began + took + FIELDS / 2 + MEASURE_REST * took;
}

/* Opens the screen for frames as they are now, if it is open for others. Returns 0 if it cannot. */
static int32 fit_screen(struct show *s)
{
    const struct scene_header *header = s->scene.header;
    struct screen_form *form = &s->form;
    const uint32 since = s->screen.since;
    const int32 was_open = s->screen.is_open;

    if (form->width == header->width)
        return 1;
    form->width = header->width;
    form->height = header->height;
    form->pixel_width = header->pixel_width;
    form->pixel_height = header->pixel_height;
    form->format = header->format;
    form->blitter = !memory_is_chip(s->frame.pixels);
    if (!screen_open(&s->screen, form))
        return 0;
    if (was_open)
        s->screen.since = since;        /* fields are counted on */
    screen_palette(&s->screen, (const uint8 *)header + header->palette_at);
    return 1;
}

/* Sets frames and materials to a rung. */
static void climb(struct show *s, const struct rung *rung)
{
    const struct scene_header *header = s->scene.header;

    if (s->scene.is_coarse != rung->is_coarse) {
        scene_set_coarse(&s->scene, rung->is_coarse);
        set_size(&s->frame, header);
        touched_begin(&s->touched, header->width, header->height);
        touched_fill(&s->touched);
    }
    s->settings = rung->settings;
    show_set(s);
}

void show_hold(struct show *s, int32 fields)
{
    static const struct rung own = {{SETTINGS_OWN, SETTINGS_OWN, 0}, 0};

    s->fields = fields;
    for (int32 i = 0; i < s->ladder.rungs; i++)
        s->governor.budget[i] = (uint32)fields * FIELD_BUDGET;
    governor_start(&s->governor, s->ladder.rungs);
    climb(s, &own);
}

int32 show_present(struct show *s)
{
    show_draw(s);
    if (!s->count && !s->is_plain && (s->paused || screen_fields(&s->screen) >= s->next_measuring))
        show_measure(s);
    if (!fit_screen(s))
        return 0;
    if (!s->is_plain)
        show_describe(s);
    screen_show(&s->screen, &s->frame, s->asked);
    return 1;
}

int32 show_timed(struct show *s, struct frame_time *time)
{
    show_draw(s);
    time->drawing = s->ticks;
    time->rung = -1;
    s->shown = times_show(&s->screen, &s->frame, s->asked, &time->showing);
    return 1;
}

int32 show_held(struct show *s, struct frame_time *time)
{
    const int32 rung = s->governor.step;
    int32 is_merged;

    show_draw(s);
    if (!fit_screen(s))
        return 0;
    is_merged = s->screen.between[0] != 0;
    if (!is_merged)             /* the planes must be free */
        s->shown = screen_wait(&s->screen);
    clock_start(NO_LIMIT);
    if (!s->times && !s->is_plain)
        show_describe(s);
    screen_prepare(&s->screen, &s->frame, s->asked);
    time->showing = clock_stop();
    time->drawing = s->ticks;
    time->rung = rung;
    if (is_merged)
        s->shown = screen_wait(&s->screen);
    screen_post(&s->screen, s->shown + (uint32)s->fields);
    if (governor_next(&s->governor, s->ticks + time->showing) != rung)
        climb(s, &s->ladder.rung[s->governor.step]);
    return 1;
}

int32 show_make(struct show *s, int32 has_times)
{
    const struct scene_header *header = s->scene.header;

    if (!make_frame(&s->frame, header))
        return outcome_lack_memory("show", "the frame");
    if (has_times && !mem_alloc(&s->times, s->count * (int32)sizeof *s->times, MEMORY_ANY))
        return outcome_lack_memory("show", "the times");
    if (!counts_make(&s->counts, header->materials))
        return outcome_lack_memory("show", "the counts");
    if (!clock_open())
        return outcome_lack("show", "another program uses CIA-B's timers");
    if (!fit_screen(s))
        return 0;
    touched_begin(&s->touched, header->width, header->height);
    touched_fill(&s->touched);
    scene_reserve(&s->scene);
    make_frame(&s->exact, header);
    ladder_make(&s->ladder, &s->scene);
    show_set(s);
    return 1;
}
