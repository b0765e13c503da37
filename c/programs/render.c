/* render - draws a scene's frames into chunky dumps and times them.

   render SCENE FORM addx|swap|c FRAMES n COUNT CHIP DCACHE DIGEST name OFF rules
   writes frame_000.chunky and so on into the current directory and prints one line
   a frame: number, E-clock ticks, polygons, pixels of each kind of span (with COUNT; then
   a line a material too: its polygons, those each rule applied to, pixels of each span).
   OFF names rules of lowering that are not followed, by commas: or all of them.
   CHIP puts maps and frame into chip RAM; DCACHE draws with a 68030's data cache;
   DIGEST writes a struct frame_digest for each frame into one file instead. */
#include "scene/scene.h"
#include "system/file.h"
#include "system/system.h"
#include "system/text.h"

/* Bytes before and behind the frame that nobody may touch. */
#define GUARD 4096
#define GUARD_BYTE 0xa5
#define GUARD_LONGWORD 0xa5a5a5a5u

/* Longest time for one frame, in 92 ms: 60 s, a thousand times what a polygon takes. */
#define FRAME_LIMIT 650

static const char *const span_names[SPAN_KINDS] = {
    "fill", "fill_16", "gouraud", "affine_addx", "affine_addx_wrap", "affine_row",
    "affine_column", "affine_scanline", "affine_swap", "affine_c", "arbitrary", "tiled",
    "columns", "columns_16", "generated", "lit", "lit_wrap", "lit_gouraud",
    "perspective_pieces", "perspective_curves", "reciprocal", "logarithm",
    "affine_copy", "affine_short", "affine_short_wrap", "affine_row_short", "gouraud_short",
    "lit_short", "lit_short_wrap"
};

static const char *const rule_names[RULES] = {
    "outside", "equal_shades", "equal_levels", "no_light", "full_light", "constant_w",
    "tolerance", "coarser", "inside_frame", "inside_range", "still_v", "unit_step",
    "still_u", "no_wrap", "no_wrap_lit", "short", "short_wrap", "short_row", "short_gouraud",
    "short_lit", "short_lit_wrap"
};

static const char *const why_refused[] = {
    "", "", "fewer than 3 or more than 64 vertices", "a vertex is out of range",
    "gradients polygon are for triangles", "its mapper cannot draw its map or this frame"
};

static int32 fail(const char *why)
{
    text_refuse("render", why);
    return RETURN_FAIL;
}

static int32 make_frame(struct frame *frame, const struct scene *scene, int32 kind)
{
    uint8 *memory;
    int32 bytes;

    frame->width = scene->header->width;
    frame->pixel_bytes = (int32)scene->header->pixel_bytes;
    frame->pitch = frame->width * frame->pixel_bytes;
    frame->height = scene->header->height;
    bytes = frame->pitch * frame->height + 2 * GUARD;
    if (!mem_alloc(&memory, bytes, kind))
        return 0;
    for (int32 i = 0; i < bytes; i++)
        memory[i] = GUARD_BYTE;
    frame->pixels = memory + GUARD;
    return 1;
}

/* Bits of both guard bands that are not what they were. */
static uint32 guards_broken(const struct frame *frame)
{
    const uint32 *before = (const uint32 *)(frame->pixels - GUARD);
    const uint32 *behind = (const uint32 *)(frame->pixels + frame->pitch * frame->height);
    uint32 broken = 0;

    for (int32 i = GUARD / 4; i > 0; i--)
        broken |= (*before++ ^ GUARD_LONGWORD) | (*behind++ ^ GUARD_LONGWORD);
    return broken;
}

static void frame_name(char *name, int32 number)
{
    const char *pattern = "frame_000.chunky";

    while ((*name++ = *pattern++) != 0)
        ;
    for (name -= 8; number; number /= 10)
        *--name = (char)('0' + number % 10);
}

/* How a run goes. */
struct run {
    int32 frames;
    struct drawing drawing;
    struct draw_counts *counted, *totals;       /* one a material each, or 0 */
    const char *digest;         /* name of the file, or 0: dumps */
};

/* Those counts of a list that are not 0, by name. */
static void add_counts(const uint32 *counts, const char *const *names, int32 items)
{
    for (; items > 0; items--, counts++, names++)
        if (*counts) {
            text_add(" ");
            text_add(*names);
            text_add(" ");
            text_number((int32)*counts);
        }
}

static void sum_up(struct draw_counts *to, const struct draw_counts *from)
{
    uint32 *sum = (uint32 *)to;
    const uint32 *more = (const uint32 *)from;

    for (uint32 i = sizeof *to / sizeof *sum; i > 0; i--)
        *sum++ += *more++;
}

static void clear_counts(struct draw_counts *counts, uint32 materials)
{
    uint32 *to = (uint32 *)counts;

    for (uint32 i = materials * (sizeof *counts / sizeof *to); i > 0; i--)
        *to++ = 0;
}

/* One frame of all materials. */
static void report(int32 number, uint32 ticks, const struct run *run, uint32 materials)
{
    struct draw_counts all;

    clear_counts(&all, 1);
    for (uint32 i = 0; i < materials; i++) {
        sum_up(&all, &run->counted[i]);
        sum_up(&run->totals[i], &run->counted[i]);
    }
    text_add("frame ");
    text_number(number);
    text_add(" ticks ");
    text_number((int32)ticks);
    text_add(" polygons ");
    text_number((int32)all.polygons);
    add_counts(all.pixels, span_names, SPAN_KINDS);
    text_print();
}

/* All frames of one material. */
static void report_materials(const struct draw_counts *counts, uint32 materials)
{
    for (uint32 i = 0; i < materials; i++, counts++) {
        text_add("material ");
        text_number((int32)i);
        text_add(" polygons ");
        text_number((int32)counts->polygons);
        text_add(" rules");
        add_counts(counts->rules, rule_names, RULES);
        text_add(" spans");
        add_counts(counts->pixels, span_names, SPAN_KINDS);
        text_print();
    }
}

/* Draws a frame, between quiet_enter and quiet_leave, and looks at the guard bands. */
static int32 draw(const struct scene *scene, const struct frame *frame, int32 number,
                  const struct run *run, struct frame_digest *drawn)
{
    enum polygon_result result;
    struct drawing drawing;

    drawing.form = run->drawing.form;
    drawing.off = run->drawing.off;
    drawing.counts = 0;
    quiet_enter();
    clock_start(FRAME_LIMIT);
    result = scene_draw(scene, frame, number, &drawing);
    drawn->ticks = clock_stop();
    quiet_leave();
    drawn->result = result;
    if (guards_broken(frame)) {
        text_add("frame ");
        text_number(number);
        text_add(": bytes outside the frame were written");
        text_print();
        return 0;
    }
    return 1;
}

/* Draws all frames; *refused: why a polygon was, or POLYGON_DRAWN. */
static int32 dump_frames(const struct scene *scene, const struct frame *frame,
                         const struct run *run, uint32 *refused)
{
    uint32 materials = run->counted ? scene->header->materials : 0;

    for (int32 number = 0; number < run->frames; number++) {
        struct frame_digest drawn;
        char name[20];

        if (!draw(scene, frame, number, run, &drawn))
            return 0;
        if (drawn.result != POLYGON_DRAWN)
            *refused = drawn.result;
        if (run->counted) {             /* again, since counting takes time */
            clear_counts(run->counted, materials);
            scene_draw(scene, frame, number, &run->drawing);
        }
        frame_name(name, number);
        if (!file_save(name, frame->pixels, (uint32)(frame->pitch * frame->height)))
            return 0;
        report(number, drawn.ticks, run, materials);
    }
    report_materials(run->totals, materials);
    return 1;
}

/* Each step keeps different hashes different, so one longword that differs always shows. */
static void add_up(const struct frame *frame, struct frame_digest *digest)
{
    const uint32 *pixels = (const uint32 *)frame->pixels;
    uint32 sum = 0, hash = 0;

    for (int32 i = frame->pitch * frame->height / 4; i > 0; i--) {
        uint32 four = *pixels++;

        sum += four;
        hash = ((hash << 16 | hash >> 16) ^ four) * FRAME_HASH;
    }
    digest->sum = sum;
    digest->hash = hash;
}

/* The same, but for the frames' digests in one file, and a line now and then. */
static int32 digest_frames(const struct scene *scene, const struct frame *frame,
                           const struct run *run)
{
    static struct frame_digest digests[SCENE_FRAMES_MAX];

    for (int32 number = 0; number < run->frames; number++) {
        if (number % 50 == 0) {
            text_add("from frame ");
            text_number(number);
            text_print();
        }
        if (!draw(scene, frame, number, run, &digests[number]))
            return 0;
        add_up(frame, &digests[number]);
    }
    return file_save(run->digest, digests, (uint32)run->frames * sizeof *digests);
}

static int32 render(const struct scene *scene, const struct frame *frame, const struct run *run)
{
    uint32 refused = POLYGON_DRAWN;

    if (run->digest)
        return digest_frames(scene, frame, run) ? RETURN_OK : RETURN_FAIL;
    if (!dump_frames(scene, frame, run, &refused))
        return RETURN_FAIL;
    if (refused != POLYGON_DRAWN) {
        text_refuse("render: not all could be drawn", why_refused[refused]);
        return RETURN_WARN;
    }
    return RETURN_OK;
}

/* The form of this name; -1: there is none. */
static int32 form_of(const char *name)
{
    return text_same(name, "addx") ? FORM_ADDX
         : text_same(name, "swap") ? FORM_SWAP
         : text_same(name, "c") ? FORM_C : -1;
}

/* The rule whose name stands before the next comma, or RULES. */
static uint32 rule_of(const char *name, int32 length)
{
    uint32 rule = 0;

    for (; rule < RULES; rule++) {
        const char *other = rule_names[rule];
        int32 i = 0;

        while (i < length && other[i] == name[i])
            i++;
        if (i == length && !other[i])
            break;
    }
    return rule;
}

/* A bit for each rule in a list by commas; 0: there is no such rule. */
static uint32 rules_of(const char *names)
{
    uint32 off = 0;

    if (text_same(names, "all"))
        return ((uint32)1 << RULES) - 1;
    for (;;) {
        int32 length = 0;
        uint32 rule;

        while (names[length] && names[length] != ',')
            length++;
        rule = rule_of(names, length);
        if (rule == RULES)
            return 0;
        off |= (uint32)1 << rule;
        if (!names[length])
            return off;
        names += length + 1;
    }
}

static int32 make_counts(struct run *run, uint32 materials)
{
    int32 bytes = (int32)(materials * sizeof *run->totals);

    if (!mem_alloc(&run->counted, bytes, MEMORY_ANY)
        || !mem_alloc(&run->totals, bytes, MEMORY_ANY))
        return 0;
    clear_counts(run->totals, materials);
    run->drawing.counts = run->counted;
    return 1;
}

int main(void)
{
    enum { SCENE, FORM, FRAMES, COUNT, CHIP, DCACHE, DIGEST, OFF, ITEMS };
    static int32 args[ITEMS];
    struct scene scene;
    struct frame frame;
    struct run run = {0, {FORM_ADDX, 0, 0}, 0, 0, 0};
    int32 kind, result, form;

    if (!args_read("SCENE/A,FORM/K,FRAMES/K/N,COUNT/S,CHIP/S,DCACHE/S,DIGEST/K,OFF/K", args))
        return fail("usage: render SCENE [FORM addx|swap|c] [FRAMES n] [COUNT] [CHIP] [DCACHE] "
                    "[DIGEST name] [OFF rules]");
    if (args[FORM]) {
        form = form_of((const char *)args[FORM]);
        if (form < 0)
            return fail("FORM: not one of addx, swap, c");
        run.drawing.form = (enum form)form;
    }
    if (args[OFF]) {
        run.drawing.off = rules_of((const char *)args[OFF]);
        if (!run.drawing.off)
            return fail("OFF: not a rule of lowering, or all");
    }
    kind = args[CHIP] ? MEMORY_CHIP : MEMORY_ANY;
    if (!scene_load(&scene, (const char *)args[SCENE], kind))
        return RETURN_FAIL;
    run.digest = (const char *)args[DIGEST];
    run.frames = scene.header->frames;
    if (args[FRAMES]) {
        int32 asked = *(const int32 *)args[FRAMES];

        if (asked < 1 || asked > run.frames)
            return fail("FRAMES: not between 1 and the scene's frames");
        run.frames = asked;
    }
    if (args[COUNT] && !make_counts(&run, scene.header->materials))
        return fail("not enough memory for the counts");
    if (!make_frame(&frame, &scene, kind))
        return fail("not enough memory for the frame");
    if (!clock_open())
        return fail("another program uses CIA-B's timers");
    if (args[DCACHE] && !cache_data(1)) {
        clock_close();
        return fail("DCACHE: this processor has no data cache");
    }
    result = render(&scene, &frame, &run);
    if (args[DCACHE])
        cache_data(0);
    clock_close();
    return result;
}
