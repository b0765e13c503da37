/* show - plays a scene on the screen and says what it costs.

   show SCENE FRAME n PAUSE ACCURACY n PERSPECTIVE n COUNT n TIMES
   Draws all frames from FRAME on, then again from the first, as 8 bitplanes or HAM8. PAUSE begins
   paused. COUNT shows so many frames without measuring their errors, and prints how many fields they
   took; TIMES shows no status lines, and prints a line for each frame too: ticks of its drawing and of its
   conversion, with the wait for the blitter, and since which field it was shown. ACCURACY and PERSPECTIVE
   are steps (scene/settings.h) from 0; the default is the scene's settings. Keys: space pauses and resumes;
   cursor left and right change the accuracy, down and up the perspective, each from cheap to exact; S
   restores the scene's settings; escape leaves.
   Returns 0, 5 after Ctrl-C or if a polygon could not be drawn, 10 for arguments and files, 20.

   The status lines below the picture:
   - frames per second, of some 50 fields: drawing, conversion, the wait for the field and this
     line, but no measuring;
   - cycles a pixel: of drawing alone, from the background to the last polygon, by the clock, over the
     pixels of all polygons, hidden ones too. DMA and interrupts are on, the display's too, so it is
     more than `render` says. Pixels are counted after that, for the frames that are measured;
   - how many pixels differ from the most accurate steps of both axes: by drawing the frame a second time
     into a buffer of its own. A frame is measured when paused, and one now and then while it runs, so that
     no more than a fifth of the time goes there; the figures of all that were since the last change of a
     step are added up. */
#include "frames/frames.h"
#include "polygon/scratch.h"
#include "scene/settings.h"
#include "screen/screen.h"
#include "show/figures.h"
#include "show/times.h"
#include "system/arguments.h"
#include "system/machine.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define NO_LIMIT 65535          /* of the clock: the watchdog is off */
#define MEASURE_REST 4          /* the pause after measuring, in times that it took */
#define COUNT_MAX 9999
#define READ_BEYOND 32          /* bytes after a frame that its conversion may read */
#define KEYS "arrows, S, space, Esc"    /* at the end of the second status line */

struct show {
    struct scene scene;
    struct frame frame, exact;  /* exact.pixels is 0 if memory is short */
    struct touched touched;     /* of frame, where that begins with the background */
    struct touched *asked;      /* that, or 0 if it is drawn whole */
    struct screen screen;
    struct settings settings;
    struct renderer renderer;
    struct scratch scratch;
    struct scene_counts counts;
    struct measured measured;
    struct rate rate;
    uint32 next_measuring;      /* field */
    int32 number, paused;
    int32 count;                /* of frames to show; 0: until a key ends it */
    int32 is_broken;            /* by Ctrl-C */
    int32 has_tables;           /* 0: no memory for tables of perspective */
    uint32 ticks;               /* of the last frame */
    struct frame_time *times;   /* of each frame counted; 0: they are not asked for */
    uint32 refused;             /* enum polygon_result: the last one refused, or POLYGON_DRAWN */
};

static int32 make_frame(struct frame *frame, const struct scene_header *header)
{
    uint8 *pixels;

    frame->width = header->width;
    frame->height = header->height;
    frame->pixel_bytes = scene_pixel_bytes(header->format);
    frame->pitch = frame->width * frame->pixel_bytes;
    frame->pixels = 0;
    if (!mem_alloc(&pixels, frame->pitch * frame->height + READ_BEYOND, MEMORY_ANY))
        return 0;
    frame->pixels = pixels;
    return 1;
}

static void set(struct show *s)
{
    s->has_tables = settings_set(&s->scene, &s->settings);
    measured_clear(&s->measured);
    s->next_measuring = 0;
}

static void draw(struct show *s)
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
    static const struct settings best = {ACCURACY_STEPS - 1, PERSPECTIVE_KINDS - 1};

    settings_set(&s->scene, &best);
    s->renderer.frame = &s->exact;
    scene_draw(&s->renderer, &s->scene, s->number);
    s->renderer.frame = &s->frame;
    settings_set(&s->scene, &s->settings);
    measured_compare(&s->measured, &s->frame, &s->exact);
}

/* Measures the frame that was just drawn. */
static void measure(struct show *s)
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

/* Puts the keys at the end of a status line, if there is room. */
static void add_keys(char *text)
{
    static const char keys[] = KEYS;
    int32 at = 0, from = STATUS_COLUMNS - (int32)sizeof keys + 1;

    while (text[at])
        at++;
    if (at >= from)
        return;
    while (at < from)
        text[at++] = ' ';
    for (const char *key = keys; (text[at] = *key); key++)
        at++;
}

static void describe(struct show *s)
{
    char text[2 * STATUS_COLUMNS];

    if (s->paused) {
        text_add("paused, frame ");
        text_number(s->number);
    } else
        figures_rate(&s->rate);
    text_add("   ");
    figures_cost(&s->measured);
    text_add("   ");
    if (s->exact.pixels)
        figures_error(&s->measured);
    else
        text_add("error: no memory");
    text_take(text);
    screen_text(&s->screen, 0, text);
    text_add(settings_accuracy(s->settings.accuracy));
    text_add("   perspective ");
    text_add(settings_perspective(s->settings.perspective));
    if (!s->has_tables)
        text_add("   (no memory for tables)");
    text_take(text);
    add_keys(text);
    screen_text(&s->screen, 1, text);
}

/* Draws the current frame and shows it. */
static void present(struct show *s)
{
    draw(s);
    if (!s->count && (s->paused || screen_fields(&s->screen) >= s->next_measuring))
        measure(s);
    describe(s);
    screen_show(&s->screen, &s->frame, s->asked);
}

/* Moves a setting by one step; from the scene's setting, to the most exact step. */
static void move(struct show *s, int32 *step, int32 steps, int32 by)
{
    const int32 to = *step == SETTINGS_OWN ? steps - 1 : *step + by;

    if (to < 0 || to >= steps)
        return;
    *step = to;
    set(s);
}

/* Acts on a key; returns 0 to leave. */
static int32 follow(struct show *s, uint32 key)
{
    switch (key) {
    case KEY_ESCAPE:
        return 0;
    case KEY_SPACE:
        s->paused = !s->paused;
        set(s);
        break;
    case KEY_LEFT:
        move(s, &s->settings.accuracy, ACCURACY_STEPS, -1);
        break;
    case KEY_RIGHT:
        move(s, &s->settings.accuracy, ACCURACY_STEPS, 1);
        break;
    case KEY_DOWN:
        move(s, &s->settings.perspective, PERSPECTIVE_KINDS, -1);
        break;
    case KEY_UP:
        move(s, &s->settings.perspective, PERSPECTIVE_KINDS, 1);
        break;
    case KEY_S:
        s->settings.accuracy = s->settings.perspective = SETTINGS_OWN;
        set(s);
        break;
    default:
        return 1;
    }
    rate_begin(&s->rate, screen_fields(&s->screen));
    return 1;
}

/* Acts on the keys pressed; when paused, waits for one. Returns 0 to leave. */
static int32 follow_keys(struct show *s)
{
    uint32 key;

    for (;;) {
        if (outcome_break()) {
            s->is_broken = 1;
            return 0;
        }
        key = key_take();
        if (key != NO_KEY || !s->paused)
            break;
        display_wait(display_fields());
    }
    for (; key != NO_KEY; key = key_take())
        if (!follow(s, key))
            return 0;
    return 1;
}

/* Returns the return code, after a line if something was refused. */
static int32 ended(const struct show *s)
{
    if (s->refused == POLYGON_DRAWN)
        return outcome_code(!s->is_broken);
    text_refuse("show: not all could be drawn", scene_why(&s->scene, s->refused));
    return RETURN_WARN;
}

static void next_frame(struct show *s)
{
    if (++s->number == s->scene.header->frames)
        s->number = 0;
}

static int32 play(struct show *s)
{
    rate_begin(&s->rate, screen_fields(&s->screen));
    present(s);
    while (follow_keys(s)) {
        if (!s->paused)
            next_frame(s);
        present(s);
        rate_count(&s->rate, screen_fields(&s->screen));
    }
    screen_close(&s->screen);
    return ended(s);
}

/* Shows s->count frames without status lines. */
static void play_timed(struct show *s)
{
    const uint32 began = screen_wait(&s->screen);
    int32 i = 0;

    for (; i < s->count && !s->is_broken; i++) {
        uint32 before;

        next_frame(s);
        draw(s);
        s->times[i].drawing = s->ticks;
        before = times_show(&s->screen, &s->frame, s->asked, &s->times[i]);
        if (i)
            s->times[i - 1].shown = before - began;
        s->is_broken = outcome_break();
    }
    s->times[i - 1].shown = screen_wait(&s->screen) - began;
}

/* Shows s->count frames after a first one and prints how long that took, and what TIMES asks for. */
static int32 play_counted(struct show *s)
{
    uint32 began;

    present(s);
    began = screen_wait(&s->screen);
    if (s->times)
        play_timed(s);
    else
        for (int32 i = 0; i < s->count && !s->is_broken; i++) {
            next_frame(s);
            present(s);
            s->is_broken = outcome_break();
        }
    began = screen_wait(&s->screen) - began;
    screen_close(&s->screen);
    text_number(s->count);
    text_add(" frames in ");
    text_number((int32)began);
    text_add(" fields");
    text_print();
    if (s->times && !s->is_broken)
        times_print(s->times, s->count);
    return ended(s);
}

/* Allocates what is necessary, then what is optional. Prints a line and returns 0 if something
   necessary is lacking. */
static int32 make(struct show *s, int32 has_times)
{
    const struct scene_header *header = s->scene.header;
    struct screen_form form = {header->width, header->height, header->pixel_width, header->pixel_height,
                               header->format, 0};

    if (!make_frame(&s->frame, header))
        return outcome_lack_memory("show", "the frame");
    if (has_times && !mem_alloc(&s->times, s->count * (int32)sizeof *s->times, MEMORY_ANY))
        return outcome_lack_memory("show", "the times");
    if (!counts_make(&s->counts, header->materials))
        return outcome_lack_memory("show", "the counts");
    if (!clock_open())
        return outcome_lack("show", "another program uses CIA-B's timers");
    form.blitter = !memory_is_chip(s->frame.pixels);
    if (!screen_open(&s->screen, &form))
        return 0;
    screen_palette(&s->screen, (const uint8 *)header + header->palette_at);
    touched_begin(&s->touched, header->width, header->height);
    touched_fill(&s->touched);
    scene_reserve(&s->scene);
    make_frame(&s->exact, header);
    set(s);
    return 1;
}

int main(void)
{
    enum { SCENE, FRAME, PAUSE, ACCURACY, PERSPECTIVE, COUNT, TIMES, ITEMS };
    int32 args[ITEMS] = {0};
    static struct show show;

    if (!args_read("SCENE/A,FRAME/K/N,PAUSE/S,ACCURACY/K/N,PERSPECTIVE/K/N,COUNT/K/N,TIMES/S", args)) {
        text_refuse("show", "usage: show SCENE [FRAME n] [PAUSE] [ACCURACY n] [PERSPECTIVE n] [COUNT n [TIMES]]");
        return RETURN_ERROR;
    }
    show.renderer.frame = &show.frame;
    show.renderer.scratch = &show.scratch;
    show.settings.accuracy = show.settings.perspective = SETTINGS_OWN;
    show.paused = args[PAUSE] != 0;
    if (!number_asked("show", args[ACCURACY], 0, ACCURACY_STEPS, &show.settings.accuracy,
                      "ACCURACY: not between 0 and 5")
        || !number_asked("show", args[PERSPECTIVE], 0, PERSPECTIVE_KINDS,
                         &show.settings.perspective, "PERSPECTIVE: not between 0 and 4")
        || !number_asked("show", args[COUNT], 1, COUNT_MAX + 1, &show.count, "COUNT: not between 1 and 9999"))
        return RETURN_ERROR;
    if (!scene_load(&show.scene, (const char *)args[SCENE], MEMORY_ANY))
        return outcome_code(0);
    if (!number_asked("show", args[FRAME], 0, show.scene.header->frames, &show.number,
                      "FRAME: not one of the scene's"))
        return RETURN_ERROR;
    if (!make(&show, args[COUNT] && args[TIMES]))
        return outcome_code(0);
    return show.count ? play_counted(&show) : play(&show);
}
