/* render - draws a scene's frames into chunky dumps and times them.

   render SCENE FORM addx|swap|c FRAMES n COUNT CHIP DCACHE DIGEST name OFF rules UNTIMED EXACT
   writes frame_000.chunky and so on into the current directory and prints one line
   a frame: number, ticks (colour clocks), polygons, pixels of each kind of span (with COUNT; then
   a line a material too: its polygons, those each rule applied to, pixels of each span).
   CHIP puts maps and frame into chip RAM; DCACHE draws with a 68030's data cache;
   DIGEST writes a struct frame_digest for each frame into one file instead; OFF names
   rules of lowering that are not followed, by commas, or all; UNTIMED prints 0
   as ticks and ends earlier, as it does not wait for the beam; EXACT, on UAE alone, has it
   cycle-exact while a frame is drawn and timed, and not else; ACCURACY and PERSPECTIVE
   set all materials to a step (scene/settings.h), numbered from 0. */
#include "frames/counts.h"
#include "polygon/scratch.h"
#include "scene/load.h"
#include "scene/settings.h"
#include "system/arguments.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

/* Bytes before and after the frame that must not be written. */
#define CANARY 4096
#define CANARY_BYTE 0xa5
#define CANARY_LONGWORD 0xa5a5a5a5u

/* For a wrong argument. */
static int32 refuse(const char *why)
{
    text_refuse("render", why);
    return RETURN_ERROR;
}

static int32 make_frame(struct frame *frame, const struct scene *scene, int32 kind)
{
    uint8 *memory;
    int32 bytes;

    frame->width = scene->header->width;
    frame->pixel_bytes = scene_pixel_bytes(scene->header->format);
    frame->pitch = frame->width * frame->pixel_bytes;
    frame->height = scene->header->height;
    bytes = frame->pitch * frame->height + 2 * CANARY;
    if (!mem_alloc(&memory, bytes, kind))
        return 0;
    for (int32 i = 0; i < bytes; i++)
        memory[i] = CANARY_BYTE;
    frame->pixels = memory + CANARY;
    return 1;
}

/* Returns the bits that have changed in the canaries before and after the frame. */
static uint32 canaries_broken(const struct frame *frame)
{
    const uint32 *before = (const uint32 *)(frame->pixels - CANARY);
    const uint32 *behind = (const uint32 *)(frame->pixels + frame->pitch * frame->height);
    uint32 broken = 0;

    for (int32 i = CANARY / 4; i > 0; i--)
        broken |= (*before++ ^ CANARY_LONGWORD) | (*behind++ ^ CANARY_LONGWORD);
    return broken;
}

/* The settings of a run. */
struct run {
    int32 frames;
    struct renderer renderer;
    struct scene_counts counts;
    const char *digest;         /* name of the file, or 0: dumps */
    int32 untimed, exact;
};

/* Draws a frame and looks at the canaries. */
static int32 draw(struct scene *scene, int32 number, struct run *run, struct frame_digest *drawn)
{
    drawn->ticks = 0;
    if (run->exact)
        exact_set(1);
    drawn->result = scene_time(&run->renderer, scene, number, run->untimed ? 0 : &drawn->ticks);
    if (run->exact)
        exact_set(0);
    if (canaries_broken(run->renderer.frame)) {
        text_add("frame ");
        text_number(number);
        text_add(": bytes outside the frame were written");
        text_print();
        return 0;
    }
    return 1;
}

/* Skips longwords from `at` on that are `last`, up to `end`; eight a step, as most of a frame is background. */
static const uint32 *skip_equal(const uint32 *at, const uint32 *end, uint32 last)
{
    while (end - at >= 8 && at[0] == last && at[1] == last && at[2] == last && at[3] == last
           && at[4] == last && at[5] == last && at[6] == last && at[7] == last)
        at += 8;
    while (at < end && *at == last)
        at++;
    return at;
}

/* The hash leaves out longwords equal to the one before. */
static void add_up(const struct frame *frame, struct frame_digest *digest)
{
    const uint32 *at = (const uint32 *)frame->pixels;
    const uint32 *const end = at + frame->pitch * frame->height / 4;
    uint32 sum = 0, hash = 0, last = 0;

    for (;;) {
        const uint32 *const first = at;

        if (at < end && *at == last) {
            at = skip_equal(at, end, last);
            sum += last * (uint32)(at - first);
        }
        if (at == end)
            break;
        last = *at;
        sum += last;
        hash = ((hash << 16 | hash >> 16) ^ last) * FRAME_HASH + (uint32)(end - at);
        at++;
    }
    digest->sum = sum;
    digest->hash = hash;
}

/* Draws a frame once more to count; looks whether it is the same if its digest is given. */
static int32 count(struct scene *scene, int32 number, struct run *run,
                   const struct frame_digest *drawn)
{
    struct frame_digest counted;

    counts_frame(&run->counts, &run->renderer, scene, number);
    if (!drawn)
        return 1;
    add_up(run->renderer.frame, &counted);
    if (counted.sum == drawn->sum && counted.hash == drawn->hash)
        return 1;
    text_add("frame ");
    text_number(number);
    text_add(": drawn once more to be counted, it differs");
    text_print();
    return 0;
}

/* Prints a line about a frame that was drawn: all, or where only digests are asked for, where it is. */
static void report(const struct run *run, int32 number, uint32 ticks)
{
    if (run->digest && !run->counts.materials) {
        if (number % 50)
            return;
        text_add("until frame ");
        text_number(number);
    } else {
        text_add("frame ");
        text_number(number);
        text_add(" ticks ");
        text_number((int32)ticks);
        counts_add(&run->counts);
    }
    text_print();
}

/* Draws all frames; *refused: why a polygon was, or POLYGON_DRAWN. */
static int32 draw_frames(struct scene *scene, struct run *run, struct frame_digest *digests,
                         uint32 *refused)
{
    for (int32 number = 0; number < run->frames; number++) {
        struct frame_digest one;
        struct frame_digest *drawn = digests ? &digests[number] : &one;

        if (!draw(scene, number, run, drawn))
            return 0;
        if (drawn->result != POLYGON_DRAWN)
            *refused = drawn->result;
        if (digests)
            add_up(run->renderer.frame, drawn);
        if (run->counts.materials && !count(scene, number, run, digests ? drawn : 0))
            return 0;
        if (!digests && !scene_save(run->renderer.frame, number))
            return 0;
        report(run, number, drawn->ticks);
        if (number + 1 < run->frames && outcome_break())
            return 0;
    }
    counts_print(&run->counts);
    return 1;
}

static int32 render(struct scene *scene, struct run *run)
{
    uint32 refused = POLYGON_DRAWN;
    struct frame_digest *digests = 0;
    int32 bytes = run->frames * (int32)sizeof *digests;

    if (run->digest && !mem_alloc(&digests, bytes, MEMORY_ANY))
        return outcome_code(outcome_lack_memory("render", "the digests"));
    if (!draw_frames(scene, run, digests, &refused))
        return outcome_code(0);
    if (digests)
        return outcome_code(file_save(run->digest, digests, (uint32)bytes));
    if (refused != POLYGON_DRAWN) {
        text_refuse("render: not all could be drawn", scene_why(scene, refused));
        return RETURN_WARN;
    }
    return RETURN_OK;
}

/* Returns the form with this name, or -1 if there is none. */
static int32 form_named(const char *name)
{
    return text_same(name, "addx") ? FORM_ADDX
         : text_same(name, "swap") ? FORM_SWAP
         : text_same(name, "c") ? FORM_C : -1;
}

int main(void)
{
    enum { SCENE, FORM, FRAMES, COUNT, CHIP, DCACHE, DIGEST, OFF, UNTIMED, EXACT, ACCURACY,
           PERSPECTIVE, ITEMS };
    int32 args[ITEMS] = {0};
    static struct scene scene;  /* not on the stack, of which a shell gives 4,096 bytes */
    struct frame frame;
    struct run run = {0, {&frame, FORM_ADDX, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0}, 0, 0, 0};
    struct settings settings = {SETTINGS_OWN, SETTINGS_OWN, 0};
    int32 kind, form;

    if (!args_read("SCENE/A,FORM/K,FRAMES/K/N,COUNT/S,CHIP/S,DCACHE/S,DIGEST/K,OFF/K,"
                   "UNTIMED/S,EXACT/S,ACCURACY/K/N,PERSPECTIVE/K/N", args))
        return refuse("usage: render SCENE [FORM addx|swap|c] [FRAMES n] [COUNT] [CHIP] [DCACHE] "
                      "[DIGEST name] [OFF rules] [UNTIMED] [EXACT] [ACCURACY n] [PERSPECTIVE n]");
    if (args[FORM]) {
        form = form_named((const char *)args[FORM]);
        if (form < 0)
            return refuse("FORM: not one of addx, swap, c");
        run.renderer.form = (enum form)form;
    }
    if (args[OFF]) {
        run.renderer.off = rules_named((const char *)args[OFF]);
        if (!run.renderer.off)
            return refuse("OFF: not a rule of lowering, or all");
    }
    kind = args[CHIP] ? MEMORY_CHIP : MEMORY_ANY;
    if (!scene_load(&scene, (const char *)args[SCENE], kind))
        return outcome_code(0);
    run.digest = (const char *)args[DIGEST];
    run.untimed = args[UNTIMED];
    run.exact = args[EXACT];
    run.frames = scene.header->frames;
    if (!number_asked("render", args[FRAMES], 1, run.frames + 1, &run.frames,
                      "FRAMES: not between 1 and the scene's frames")
        || !number_asked("render", args[ACCURACY], 0, ACCURACY_STEPS, &settings.accuracy,
                         "ACCURACY: not between 0 and 5")
        || !number_asked("render", args[PERSPECTIVE], 0, PERSPECTIVE_KINDS,
                         &settings.perspective, "PERSPECTIVE: not between 0 and 4"))
        return RETURN_ERROR;
    if ((args[ACCURACY] || args[PERSPECTIVE]) && !settings_set(&scene, &settings))
        return outcome_code(outcome_lack_memory("render", "the tables of perspective"));
    if (args[COUNT] && !counts_make(&run.counts, scene.header->materials))
        return outcome_code(outcome_lack_memory("render", "the counts"));
    if (!make_frame(&frame, &scene, kind))
        return outcome_code(outcome_lack_memory("render", "the frame"));
    if (!mem_alloc(&run.renderer.scratch, scratch_bytes(frame.width, frame.height,
                                                        scene.header->units || scene.header->pipes), MEMORY_ANY))
        return outcome_code(outcome_lack_memory("render", "the lines"));
    scene_reserve(&scene);
    if (!clock_open())
        return outcome_code(outcome_lack("render", "another program uses CIA-B's timers"));
    if (args[DCACHE] && !cache_data())
        return outcome_code(outcome_lack("render", "DCACHE: this processor has no data cache"));
    return render(&scene, &run);
}
