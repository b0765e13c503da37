/* display - opens the screen in the ways that tests/screen/test_display.py needs.

   display MODE n FORMAT n WIDTH n HEIGHT n NAME name */
#include "scene/scene_file.h"
#include "screen/screen.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

uint32 field_lines(void);               /* tests/guest/state.s; the others: events.s */
void send_event(uint32 class, uint32 code, uint32 qualifier);
uint32 break_signal(void);
void spin(void);
void illegal(void);

enum mode { SHOW, KEYS, CRASH, QUIET_CRASH, AGAIN, SHORT, REFUSED, POST, BUSY, BLITTER, BOXES, BLIT_BOXES,
            UNALIGNED };
enum event { RAW_KEY = 1, RAW_MOUSE = 2, RELEASED = 0x80, CONTROL = 8, REPEAT = 0x200, C_KEY = 0x33 };

#define DUMPED 7
#define FRAMES 3
#define SPINS 1500              /* some 860 fields */
#define NO_LIMIT 65535          /* of the clock */
/* The part of the last frame that is converted. */
#define BOX_X 32
#define BOX_Y 3
#define BOX_WIDTH 64
#define BOX_HEIGHT 5
#define LINES 312               /* of a field */
#define LEFT_OVER 100000        /* most bytes of chip RAM that SHORT leaves */

static struct screen screen;

static void print_numbers(const uint32 *from, int32 count)
{
    for (; count; count--) {
        text_number((int32)*from++);
        text_add(" ");
    }
    text_print();
}

/* Saves the screen's memory to a file; prints its address and places. Returns 0 on failure. */
static int32 dump(const char *name, int32 number)
{
    char file[64];
    uint32 found[DUMPED];

    found[0] = (uint32)screen.chip;
    found[1] = display_shown();
    found[2] = (uint32)screen.list[0];
    found[3] = (uint32)screen.list[1];
    found[4] = (uint32)screen.hidden;
    found[5] = screen_fields(&screen);
    found[6] = field_lines();
    print_numbers(found, DUMPED);
    text_add(name);
    text_add(".");
    text_number(number);
    text_take(file);
    return file_save(file, screen.chip, (uint32)screen.chip_bytes);
}

/* Shows frames: by screen_show, or converted by the processor alone; a box of the last one always so. */
static int32 show(struct frame *frame, const char *name, int32 blits)
{
    static const char *const texts[] = {"0 first line", "1 [\\]^_`{|}~\177 \200beyond", "2"};
    uint8 *palette, *pixels;
    uint32 bytes;

    if (!file_load("palette", &palette, &bytes) || !file_load(name, &pixels, &bytes))
        return RETURN_FAIL;
    screen_palette(&screen, palette);
    for (int32 i = 0; i < FRAMES; i++) {
        frame->pixels = pixels + i * frame->pitch * frame->height;
        if (i == FRAMES - 1)
            screen_convert_box(&screen, frame, BOX_X, BOX_Y, BOX_WIDTH, BOX_HEIGHT);
        else if (blits)
            screen_show(&screen, frame, 0);
        else
            screen_convert(&screen, frame);
        screen_text(&screen, i & 1, texts[i]);
        if (blits && i < FRAMES - 1)
            screen_wait(&screen);
        else
            screen_swap(&screen);
        if (!dump(name, i))
            return RETURN_FAIL;
    }
    return RETURN_OK;                   /* the screen stays open */
}

/* Shows frames of which a file has the boxes that differ from their background: how many frames there are; for each, how
   many boxes, or -1 if it is converted whole, and these. */
static int32 show_boxes(struct frame *frame, const char *name)
{
    struct touched touched;
    char file[64];
    uint8 *boxes, *pixels;
    const int32 *at;
    uint32 bytes;
    int32 frames;

    text_add(name);
    text_add(".boxes");
    text_take(file);
    if (!file_load(file, &boxes, &bytes) || !file_load(name, &pixels, &bytes))
        return RETURN_FAIL;
    at = (const int32 *)boxes;
    frames = *at++;
    touched_begin(&touched, frame->width, frame->height);
    for (int32 i = 0; i < frames; i++) {
        const int32 count = *at++;

        touched_clear(&touched);
        for (int32 left = count; left > 0; left--, at += 4)
            touched_add(&touched, (const struct rectangle *)at);
        frame->pixels = pixels + i * frame->pitch * frame->height;
        screen_show(&screen, frame, count < 0 ? 0 : &touched);
        screen_wait(&screen);
        if (!dump(name, i))
            return RETURN_FAIL;
    }
    return RETURN_OK;
}

/* Prints what the calls return for frames whose pixels or pitch are not multiples of 8, for one that lacks a row, and which
   set is hidden then; at last for a frame that fits. */
static int32 unaligned(struct frame *frame)
{
    static const uint8 off[][3] = {{4, 0, 0}, {1, 0, 0}, {0, 4, 0}, {0, 2, 0}, {0, 0, 1}, {0, 0, 0}};
    const int32 pitch = frame->pitch, height = frame->height;
    uint8 *pixels;

    if (!mem_alloc(&pixels, (pitch + 8) * (frame->height + 1), MEMORY_ANY))
        return RETURN_FAIL;
    for (uint32 i = 0; i < sizeof off / sizeof *off; i++) {
        frame->pixels = pixels + off[i][0];
        frame->pitch = pitch + off[i][1];
        frame->height = height - off[i][2];
        text_number(screen_convert(&screen, frame));
        text_number(screen_convert_box(&screen, frame, 0, 0, frame->width, 1));
        text_number(screen_show(&screen, frame, 0));
        text_number(screen.hidden);
        text_add(" ");
    }
    screen_finish(&screen);
    text_print();
    return RETURN_OK;
}

static int32 keys(void)
{
    uint32 key;

    send_event(RAW_KEY, 0x45, 0);
    send_event(RAW_KEY, 0x45, REPEAT);
    send_event(RAW_MOUSE, 0x68, 0);
    send_event(RAW_KEY, 0x45 | RELEASED, 0);
    send_event(RAW_KEY, C_KEY, 0);
    text_number((int32)break_signal());
    send_event(RAW_KEY, C_KEY, CONTROL);
    text_add(" ");
    text_number((int32)break_signal());
    for (uint32 i = 0; i < 20; i++)
        send_event(RAW_KEY, i, 0);
    for (key = key_take(); key != NO_KEY; key = key_take()) {
        text_add(" ");
        text_number((int32)key);
    }
    text_print();
    return RETURN_OK;
}

/* Opens other screens one after the other, in the same memory as long as they fit. */
static int32 again(void)
{
    static const struct screen_form small = {96, 60, 1, 1, PIXEL_CHUNKY, 0}, large = {320, 64, 1, 1, PIXEL_RGB565, 0};
    const uint8 *first = screen.chip;

    screen_close(&screen);
    screen_close(&screen);
    if (!screen_open(&screen, &small))
        return RETURN_FAIL;
    text_number(screen.chip == first);
    if (!screen_open(&screen, &large))
        return RETURN_FAIL;
    text_number(screen.chip == first);
    text_print();
    return RETURN_OK;
}

/* Prints whether a posted list waits and how many fields late it is shown; how many fields after
   its posting one is shown whose field is over; and whether display_age counts from its start. */
static int32 post(void)
{
    const uint32 due = screen_fields(&screen) + 5;
    uint32 posted;

    screen_post(&screen, due);
    text_number(screen_waits(&screen));
    text_add(" ");
    text_number((int32)(screen_wait(&screen) - due));
    text_add(" ");
    posted = screen_fields(&screen);
    screen_post(&screen, 0);
    text_number((int32)(screen_wait(&screen) - posted));
    text_add(" ");
    text_number(display_age() < LINES);
    display_wait(display_fields());
    text_number(display_age() >= LINES);
    text_print();
    return screen_waits(&screen) ? RETURN_FAIL : RETURN_OK;
}

static uint32 spin_ticks(void)
{
    clock_start(NO_LIMIT);
    spin();
    return clock_stop();
}

/* Prints the time of the same work with the system off, and then, SPINS times, with it on. */
static int32 busy(void)
{
    static uint32 ticks[1 + SPINS];

    if (!clock_open())
        return RETURN_FAIL;
    quiet_enter();
    spin();                             /* loads the cache */
    ticks[0] = spin_ticks();
    quiet_leave();
    for (int32 i = 1; i <= SPINS; i++)
        ticks[i] = spin_ticks();
    for (int32 i = 0; i <= SPINS; i++)
        print_numbers(ticks + i, 1);
    return RETURN_OK;
}

/* Takes chip RAM until less than LEFT_OVER is free in one piece. */
static void take_chip(void)
{
    void *taken;

    while (mem_alloc(&taken, LEFT_OVER, MEMORY_CHIP))
        ;
}

static int32 opened(enum mode mode, struct frame *frame, const char *name)
{
    switch (mode) {
    case SHOW: return show(frame, name, 0);
    case BLITTER: return show(frame, name, 1);
    case BOXES:
    case BLIT_BOXES: return show_boxes(frame, name);
    case UNALIGNED: return unaligned(frame);
    case KEYS: return keys();
    case AGAIN: return again();
    case POST: return post();
    case BUSY: return busy();
    case QUIET_CRASH:
        clock_open();
        quiet_enter();
        /* falls through */
    default: illegal();
    }
    return RETURN_FAIL;
}

int main(void)
{
    enum { MODE, FORMAT, WIDTH, HEIGHT, WIDE, HIGH, NAME, ITEMS };
    static int32 args[ITEMS];
    struct frame frame;
    enum mode mode;
    struct screen_form form;

    if (!args_read("MODE/A/N,FORMAT/A/N,WIDTH/A/N,HEIGHT/A/N,WIDE/A/N,HIGH/A/N,NAME", args))
        return RETURN_FAIL;
    mode = (enum mode)*(const int32 *)args[MODE];
    form.format = *(const uint32 *)args[FORMAT];
    frame.width = form.width = *(const int32 *)args[WIDTH];
    frame.height = form.height = *(const int32 *)args[HEIGHT];
    form.blitter = mode == BLITTER || mode == BLIT_BOXES || mode == UNALIGNED;
    form.pixel_width = *(const int32 *)args[WIDE];
    form.pixel_height = *(const int32 *)args[HIGH];
    frame.pixel_bytes = form.format == PIXEL_CHUNKY ? 1 : form.format == PIXEL_RGBA8888 ? 4 : 2;
    frame.pitch = frame.width * frame.pixel_bytes;
    if (mode == SHORT)
        take_chip();
    if (!screen_open(&screen, &form))
        return outcome_code(0);
    return opened(mode, &frame, (const char *)args[NAME]);
}
