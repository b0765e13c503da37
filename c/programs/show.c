/* show - plays a scene on the screen and says what it costs.

   show SCENE FRAME n PAUSE ACCURACY n PERSPECTIVE n COUNT n TIMES HOLD n PLAIN
   Draws all frames from FRAME on, then again from the first, as 8 bitplanes or HAM8. PAUSE begins
   paused. COUNT shows so many frames without measuring their errors, and prints how many fields they
   took; TIMES shows no status lines, and prints a line for each frame too: ticks of its drawing and of its
   conversion, with the wait for the blitter, and since which field it was shown. ACCURACY and PERSPECTIVE
   are steps (scene/settings.h) from 0; the default is the scene's settings. Keys: space pauses and resumes;
   cursor left and right change the accuracy, down and up the perspective, each from cheap to exact; S
   restores the scene's settings; escape leaves. HOLD shows each frame for n fields at least, and gives up
   accuracy and resolution until that is kept (show/ladder.h); G holds 25, 16.7, 12.5, 10, 8.3 frames a second,
   then none. PLAIN shows the picture alone.
   Returns 0, 5 after Ctrl-C or if a polygon could not be drawn, 10 for arguments and files, 20.

   The status lines below the picture:
   - frames per second, of some 50 fields: drawing, conversion, the wait for the field and this
     line, but no measuring; and how many that would be if frames were drawn alone, display and interrupts on;
   - cycles a pixel: of drawing alone, from the background to the last polygon, by the clock, over the
     pixels of all polygons, hidden ones too. DMA and interrupts are on, the display's too, so it is
     more than `render` says. Pixels are counted after that, for the frames that are measured;
   - how many pixels differ from the exact picture: exact edges and fine perspective, of meshes' materials that
     have none too, in the scene's own pixels, drawn into a buffer of its own. A frame is measured when paused, and one now and then
     while it runs, so that no more than a fifth of the time goes there, none while a rate is held; the figures of all that were since the last change of a
     step are added up. */
#include "show/show.h"
#include "scene/load.h"
#include "system/arguments.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define COUNT_MAX 9999
#define HELD_FIRST 2            /* fields a frame of the rates that G holds, one after the other */
#define HELD_LAST 6

/* Moves a setting by one step; from the scene's setting, to the most exact step. */
static void move(struct show *s, int32 *step, int32 steps, int32 by)
{
    const int32 to = *step == SETTINGS_OWN ? steps - 1 : *step + by;

    if (to < 0 || to >= steps)
        return;
    *step = to;
    show_set(s);
}

/* Leaves the rate that is held, if one is: settings are the user's then. */
static void let_go(struct show *s)
{
    if (s->fields)
        show_hold(s, 0);
}

/* Acts on a key; returns 0 to leave. */
static int32 follow(struct show *s, uint32 key)
{
    switch (key) {
    case KEY_ESCAPE:
        return 0;
    case KEY_SPACE:
        s->paused = !s->paused;
        show_set(s);
        break;
    case KEY_G:
        show_hold(s, !s->fields ? HELD_FIRST : s->fields < HELD_LAST ? s->fields + 1 : 0);
        break;
    case KEY_LEFT:
        let_go(s);
        move(s, &s->settings.accuracy, ACCURACY_STEPS, -1);
        break;
    case KEY_RIGHT:
        let_go(s);
        move(s, &s->settings.accuracy, ACCURACY_STEPS, 1);
        break;
    case KEY_DOWN:
        let_go(s);
        move(s, &s->settings.perspective, PERSPECTIVE_KINDS, -1);
        break;
    case KEY_UP:
        let_go(s);
        move(s, &s->settings.perspective, PERSPECTIVE_KINDS, 1);
        break;
    case KEY_S:
        let_go(s);
        s->settings.accuracy = s->settings.perspective = SETTINGS_OWN;
        show_set(s);
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

/* Closes the screen and returns the return code, after a line if something was refused. */
static int32 ended(struct show *s)
{
    screen_close(&s->screen);
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
    struct frame_time time;

    rate_begin(&s->rate, screen_fields(&s->screen));
    if (!show_present(s))
        return outcome_code(0);
    while (follow_keys(s)) {
        if (!s->paused)
            next_frame(s);
        if (!(s->fields && !s->paused ? show_held(s, &time) : show_present(s)))
            return outcome_code(0);
        rate_count(&s->rate, screen_fields(&s->screen), s->ticks);
    }
    return ended(s);
}

/* Shows s->count frames and keeps their times. Returns 0 if the screen cannot be opened. */
static int32 play_timed(struct show *s)
{
    const uint32 began = screen_wait(&s->screen);
    int32 i = 0;

    for (; i < s->count && !s->is_broken; i++) {
        next_frame(s);
        if (!(s->fields ? show_held(s, &s->times[i]) : show_timed(s, &s->times[i])))
            return 0;
        if (i)
            s->times[i - 1].shown = s->shown - began;
        s->is_broken = outcome_break();
    }
    s->times[i - 1].shown = screen_wait(&s->screen) - began;
    return 1;
}

/* The same without times. */
static int32 play_frames(struct show *s)
{
    for (int32 i = 0; i < s->count && !s->is_broken; i++) {
        next_frame(s);
        if (!show_present(s))
            return 0;
        s->is_broken = outcome_break();
    }
    return 1;
}

/* Shows s->count frames after a first one and prints how long that took, and what TIMES asks for. */
static int32 play_counted(struct show *s)
{
    uint32 began;

    if (!show_present(s))
        return outcome_code(0);
    began = screen_wait(&s->screen);
    if (!(s->times ? play_timed(s) : play_frames(s)))
        return outcome_code(0);
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

int main(void)
{
    enum { SCENE, FRAME, PAUSE, ACCURACY, PERSPECTIVE, COUNT, TIMES, HOLD, PLAIN, ITEMS };
    int32 args[ITEMS] = {0};
    static struct show show;

    if (!args_read("SCENE/A,FRAME/K/N,PAUSE/S,ACCURACY/K/N,PERSPECTIVE/K/N,COUNT/K/N,TIMES/S,HOLD/K/N,PLAIN/S", args)) {
        text_refuse("show", "usage: show SCENE [FRAME n] [PAUSE] [ACCURACY n] [PERSPECTIVE n] [HOLD n] "
                            "[PLAIN] [COUNT n [TIMES]]");
        return RETURN_ERROR;
    }
    show.renderer.frame = &show.frame;
    show.renderer.scratch = &show.scratch;
    show.settings.accuracy = show.settings.perspective = SETTINGS_OWN;
    show.paused = args[PAUSE] != 0;
    show.is_plain = args[PLAIN] != 0;
    if (!number_asked("show", args[ACCURACY], 0, ACCURACY_STEPS, &show.settings.accuracy,
                      "ACCURACY: not between 0 and 5")
        || !number_asked("show", args[PERSPECTIVE], 0, PERSPECTIVE_KINDS,
                         &show.settings.perspective, "PERSPECTIVE: not between 0 and 4")
        || !number_asked("show", args[HOLD], 1, HELD_FIELDS_MAX + 1, &show.fields, "HOLD: not between 1 and 10")
        || !number_asked("show", args[COUNT], 1, COUNT_MAX + 1, &show.count, "COUNT: not between 1 and 9999"))
        return RETURN_ERROR;
    if (!scene_load(&show.scene, (const char *)args[SCENE], MEMORY_ANY))
        return outcome_code(0);
    if (!number_asked("show", args[FRAME], 0, show.scene.header->frames, &show.number,
                      "FRAME: not one of the scene's"))
        return RETURN_ERROR;
    if (!show_make(&show, args[COUNT] && args[TIMES]))
        return outcome_code(0);
    if (show.fields)
        show_hold(&show, show.fields);
    return show.count ? play_counted(&show) : play(&show);
}
