/* demo - the parts of a script, one after the other, on the machine's screen.

   demo DIR FRAMES n PART n LOG
   DIR holds the file "parts" (demo/script.h) and its scenes; the default is PROGDIR:data. FRAMES
   shows so many frames of each part, whatever its seconds; PART shows only that part. Space skips
   to the next part, escape and Ctrl-C leave. Prints a line for each part; LOG prints more, for
   tests. */
#include "demo/log.h"
#include "demo/picture.h"
#include "scene/load.h"
#include "system/arguments.h"
#include "system/machine.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

#define PATH 256                /* bytes */
#define FRAMES_MAX 9999
#define READ_BEYOND 32          /* bytes after a frame that its conversion may read */

enum { DIR, FRAMES, PART, LOG, ITEMS };

static struct screen screen;
static struct script script;
static struct scene scene;
static struct player player;

/* For a wrong argument. */
static int32 refuse(const char *why)
{
    text_refuse("demo", why);
    return RETURN_ERROR;
}

/* Writes DIR and a name beside it to whole[PATH]; returns that, or 0 where it is too short. */
static const char *path(char *whole, const char *directory, const char *name)
{
    int32 length = 0;

    for (; *directory && length < PATH - 2; directory++)
        whole[length++] = *directory;
    if (length && whole[length - 1] != ':' && whole[length - 1] != '/')
        whole[length++] = '/';
    for (; *name && length < PATH - 1; name++)
        whole[length++] = *name;
    whole[length] = 0;
    return *name || *directory ? 0 : whole;
}

/* Sets the player's frame, of all panes, and the screen for it. */
static void make_form(const struct part *part)
{
    const struct scene_header *header = scene.header;
    struct screen_form *form = &player.form;

    form->width = form->height = 0;
    for (int32 i = 0; i < part->panes; i++) {
        const int32 right = part->pane[i].x + header->width, bottom = part->pane[i].y + header->height;

        if (form->width < right)
            form->width = right;
        if (form->height < bottom)
            form->height = bottom;
    }
    form->pixel_width = header->pixel_width;
    form->pixel_height = header->pixel_height;
    form->format = header->format;
    player.frame.width = form->width;
    player.frame.height = form->height;
    player.frame.pixel_bytes = scene_pixel_bytes(form->format);
    player.frame.pitch = form->width * player.frame.pixel_bytes;
}

/* Prints the part's number and returns 0 if its frames are not the scene's. */
static int32 is_usable(const struct part *part, int32 number)
{
    const struct scene_header *header = scene.header;
    int32 wrong = 0;

    for (int32 i = 0; i < part->panes; i++)
        wrong |= part->pane[i].worst >= header->frames;
    for (int32 i = 0; i < part->steps; i++)
        wrong |= part->step[i].first + part->step[i].frames > header->frames;
    if (!wrong)
        return 1;
    text_add("part ");
    text_number(number + 1);
    return text_refuse("", "a frame is none of its scene's");
}

/* Shows a message while a part is prepared: tables of perspective take longest. */
static void announce(const struct part *part)
{
    screen_text(&screen, 0, part->title);
    screen_text(&screen, 1, "A moment: its pictures and tables are made.");
}

/* Loads a part's scene and allocates its memory; prints a line and returns 0 if it cannot. */
static int32 load(const struct part *part, int32 number, const char *directory, uint32 frames)
{
    char whole[PATH];
    const char *name = path(whole, directory, part->scene);

    if (!name)
        return text_refuse("DIR", "too long");
    if (!scene_load(&scene, name, MEMORY_ANY))
        return 0;
    make_form(part);
    if (!is_usable(part, number))
        return 0;
    if (!mem_alloc(&player.frame.pixels, player.frame.pitch * player.frame.height + READ_BEYOND,
                   MEMORY_ANY)
        || !mem_alloc(&player.counts, (int32)(scene.header->materials * sizeof *player.counts),
                      MEMORY_ANY)
        || (frames && !mem_alloc(&player.worked, (int32)(frames * CLOCK_FIELDS * sizeof *player.worked),
                                 MEMORY_ANY)))
        return text_refuse(name, "not enough memory for its frame");
    /* the blitter's interrupts would slow one pane more than another */
    player.form.blitter = !memory_is_chip(player.frame.pixels) && part->kind != PART_RACE && part->kind != PART_FAIR;
    scene_reserve(&scene);
    return 1;
}

/* Loads and plays one part, prints its figures and releases its memory. */
static enum player_end play(int32 number, const char *directory, uint32 frames, int32 log)
{
    const uint32 before = mem_mark();
    uint8 *const chip = screen.chip;
    const int32 chip_bytes = screen.chip_bytes;
    enum player_end end = FAILED;

    player.screen = &screen;
    player.scene = &scene;
    player.part = &script.part[number];
    player.worked = 0;
    player.asked = display_fields();
    announce(player.part);
    if (load(player.part, number, directory, log ? frames : 0)) {
        end = player_play(&player, frames);
        log_part(&player, number, log);
    }
    if (screen.chip != chip) {          /* the screen allocated more, which is released below */
        screen_close(&screen);
        screen.chip = chip;
        screen.chip_bytes = chip_bytes;
    }
    mem_release(before);
    return end;
}

/* Plays all parts, or only one; returns the return code. */
static int32 play_all(const char *directory, uint32 frames, int32 only, int32 log)
{
    int32 result = RETURN_OK;

    for (int32 i = 0; i < script.parts; i++) {
        enum player_end end;

        if (only && i != only - 1)
            continue;
        end = play(i, directory, frames, log);
        if (end == LEFT)
            break;
        if (end == BROKEN)
            return RETURN_WARN;
        if (end == FAILED)
            result = RETURN_WARN;
    }
    return result;
}

int main(void)
{
    int32 args[ITEMS] = {0};
    const char *directory = "PROGDIR:data", *name;
    char whole[PATH];
    int32 frames = 0, only = 0, result;
    static const struct screen_form largest = {SCREEN_WIDTH, SCREEN_HEIGHT, 1, 1, PIXEL_CHUNKY, 0};

    if (!args_read("DIR,FRAMES/K/N,PART/K/N,LOG/S", args))
        return refuse("usage: demo [DIR] [FRAMES n] [PART n] [LOG]");
    if (args[DIR])
        directory = (const char *)args[DIR];
    name = path(whole, directory, "parts");
    if (!name)
        return refuse("DIR: too long");
    if (!script_load(&script, name))
        return outcome_code(0);
    if (!number_asked("demo", args[FRAMES], 1, FRAMES_MAX + 1, &frames,
                      "FRAMES: not between 1 and 9999")
        || !number_asked("demo", args[PART], 1, script.parts + 1, &only,
                         "PART: the script has no such part"))
        return RETURN_ERROR;
    if (!clock_open())
        return outcome_code(outcome_lack("demo", "another program uses CIA-B's timers"));
    player.renderer.scratch = &player.scratch;
    if (!screen_open(&screen, &largest))        /* its memory has room for those of larger pixels and HAM8 */
        return RETURN_FAIL;
    result = play_all(directory, (uint32)frames, only, args[LOG]);
    screen_close(&screen);
    return result;
}
