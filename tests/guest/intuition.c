/* intuition - opens screens of Intuition's in the ways that tests/screen/test_intuition.py needs.

   intuition MODE n FORMAT n WIDTH n HEIGHT n WIDE n HIGH n NAME name */
#include "polygon/polygon.h"
#include "polygon/scratch.h"
#include "screen/screen.h"
#include "system/file.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

void send_event(uint32 class, uint32 code, uint32 qualifier);   /* tests/guest/events.s */
uint32 break_signal(void);
void illegal(void);

enum mode { SHOW, WAIT, TWO, KEYS, CRASH, OPEN };
enum event { RAW_KEY = 1, RELEASED = 0x80, CONTROL = 8, REPEAT = 0x200, C_KEY = 0x33 };
enum { FRAMES = 2, SETTLED = 10, WAITED = 400, SPREAD = 40 };

static struct screen screens[2];

/* Saves a screen's planes and prints where the picture is in them. */
static int32 dump(const struct screen *screen, const char *name)
{
    const struct bitmap *const bitmap = screen->intuition->bitmap[screen->hidden ^ 1];
    const int32 distance = bitmap->plane[1] - bitmap->plane[0];

    text_number(bitmap->row_bytes);
    text_add(" ");
    text_number(distance);
    text_add(" ");
    text_number(screen->layout.left);
    text_add(" ");
    text_number(screen->layout.top);
    text_add(" ");
    text_number((int32)screen_fields(screen));
    text_print();
    return file_save(name, bitmap->plane[0], (uint32)(7 * distance + bitmap->row_bytes * bitmap->rows));
}

static void wait_fields(struct screen *screen, uint32 count)
{
    screen_post(screen, screen_fields(screen) + count);
    screen_wait(screen);
}

/* Shows frames of a file; keeps the last one shown. */
static int32 show(struct frame *frame, const char *name, int32 waits)
{
    struct screen *const screen = &screens[0];
    uint8 *palette, *pixels;
    uint32 bytes;
    char file[64];

    if (!file_load("palette", &palette, &bytes) || !file_load(name, &pixels, &bytes))
        return RETURN_FAIL;
    screen_palette(screen, palette);
    for (int32 i = 0; i < FRAMES; i++) {
        frame->pixels = pixels + i * frame->pitch * frame->height;
        if (!screen_show(screen, frame, 0))
            return RETURN_FAIL;
        screen_wait(screen);
        text_add(name);
        text_add(".");
        text_number(i);
        text_take(file);
        if (!dump(screen, file))
            return RETURN_FAIL;
    }
    screen_text(screen, 0, "nothing happens");
    while (waits-- && screen_key(screen) == NO_KEY)
        wait_fields(screen, 1);
    return RETURN_OK;                   /* the screen stays open */
}

/* Two screens at once, each with a renderer of its own; both draw by turns. */
static int32 two(const struct screen_form *form)
{
    static struct renderer renderers[2];
    static struct scratch scratch[2];
    static struct frame frames[2];
    static struct material material;
    static struct vertex corners[4];
    static struct polygon polygon;

    if (!screen_open_intuition(&screens[1], form))
        return RETURN_FAIL;
    material.mapper = MAPPER_FLAT;
    material.edges = EDGES_EXACT;
    polygon_set(&polygon, corners, 4, PLANAR_ALL);
    for (int32 k = 0; k < 2; k++) {
        frames[k].width = frames[k].pitch = form->width;
        frames[k].height = form->height;
        frames[k].pixel_bytes = 1;
        if (!mem_alloc(&frames[k].pixels, form->width * form->height, MEMORY_ANY))
            return RETURN_FAIL;
        for (int32 i = 0; i < form->width * form->height; i++)
            frames[k].pixels[i] = (uint8)k;
        renderers[k].frame = &frames[k];
        renderers[k].scratch = &scratch[k];
    }
    for (int32 i = 0; i < 8; i++) {
        const int32 k = i & 1;

        material.colour = (uint8)(16 * k + i);
        for (int32 corner = 0; corner < 4; corner++) {
            corners[corner].x = (4 * i + (corner == 1 || corner == 2 ? SPREAD : 0)) << 16;
            corners[corner].y = (3 * i + (corner > 1 ? SPREAD : 0)) << 16;
        }
        if (polygon_draw(&renderers[k], &polygon, &material) != POLYGON_DRAWN || !screen_show(&screens[k], &frames[k], 0))
            return RETURN_FAIL;
    }
    for (int32 k = 0; k < 2; k++) {
        screen_wait(&screens[k]);
        if (!dump(&screens[k], k ? "second" : "first"))
            return RETURN_FAIL;
    }
    screen_close(&screens[0]);
    return screen_open_intuition(&screens[0], form) ? RETURN_OK : RETURN_FAIL;
}

static int32 keys(void)
{
    struct screen *const screen = &screens[0];
    uint32 key;

    wait_fields(screen, SETTLED);       /* the window is active then */
    send_event(RAW_KEY, 0x45, 0);
    send_event(RAW_KEY, 0x45, REPEAT);
    send_event(RAW_KEY, 0x45 | RELEASED, 0);
    send_event(RAW_KEY, C_KEY, 0);
    send_event(RAW_KEY, C_KEY, CONTROL);
    wait_fields(screen, SETTLED);
    for (key = screen_key(screen); key != NO_KEY; key = screen_key(screen)) {
        text_number((int32)key);
        text_add(" ");
    }
    text_number((int32)break_signal());
    text_print();
    return RETURN_OK;
}

int main(void)
{
    enum { MODE, FORMAT, WIDTH, HEIGHT, WIDE, HIGH, NAME, ITEMS };
    static int32 args[ITEMS];
    static struct frame frame;
    struct screen_form form;
    enum mode mode;

    if (!args_read("MODE/A/N,FORMAT/A/N,WIDTH/A/N,HEIGHT/A/N,WIDE/A/N,HIGH/A/N,NAME", args))
        return RETURN_FAIL;
    mode = (enum mode)*(const int32 *)args[MODE];
    form.format = *(const uint32 *)args[FORMAT];
    frame.width = frame.pitch = form.width = *(const int32 *)args[WIDTH];
    frame.height = form.height = *(const int32 *)args[HEIGHT];
    frame.pixel_bytes = 1;
    form.blitter = 1;                   /* is ignored */
    form.pixel_width = *(const int32 *)args[WIDE];
    form.pixel_height = *(const int32 *)args[HIGH];
    if (!screen_open_intuition(&screens[0], &form))
        return outcome_code(0);
    switch (mode) {
    case SHOW: return show(&frame, (const char *)args[NAME], 0);
    case WAIT: return show(&frame, (const char *)args[NAME], WAITED);
    case TWO: return two(&form);
    case KEYS: return keys();
    case CRASH: illegal();
        /* falls through */
    default: return RETURN_OK;
    }
}
