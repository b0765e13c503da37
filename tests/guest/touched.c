/* touched - draws a scene's frames over one another, clearing only what the one before has touched, and compares each
   with a frame that is drawn whole.

   touched SCENE
   Prints a line for each frame: colour clocks of drawing it whole and over the other, pixels that were touched,
   and of the first wrong pixel x and y, or -1 -1. One that is not the same in both is wrong; so is one outside of what
   was touched that is not the background. */
#include "frames/frames.h"
#include "polygon/scratch.h"
#include "scene/load.h"
#include "system/arguments.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

enum { NO_LIMIT = 65535, BEYOND = 32 };

static struct scene scene;
static struct scratch scratch;
static struct renderer renderer;
static struct frame whole, over;
static struct touched touched;

static int32 make(struct frame *frame)
{
    frame->width = scene.header->width;
    frame->height = scene.header->height;
    frame->pixel_bytes = scene_pixel_bytes(scene.header->format);
    frame->pitch = frame->width * frame->pixel_bytes;
    return mem_alloc(&frame->pixels, frame->pitch * frame->height + BEYOND, MEMORY_ANY);
}

static int32 is_touched(int32 x, int32 y)
{
    const struct touched_band *const band = &touched.bands[y >> touched.rows_log];

    return x >= band->left && x < band->right;
}

/* Returns 1 if a byte is that of the background. */
static int32 is_background(int32 byte)
{
    const int32 bytes = whole.pixel_bytes;

    return over.pixels[byte] == (uint8)(scene.header->background >> 8 * (bytes - 1 - byte % bytes));
}

/* Returns the first wrong byte, or -1. */
static int32 first_wrong(void)
{
    const int32 bytes = whole.pitch * whole.height;

    for (int32 i = 0; i < bytes; i++)
        if (whole.pixels[i] != over.pixels[i]
            || (scene.header->cleared && !is_touched(i % whole.pitch / whole.pixel_bytes, i / whole.pitch)
                && !is_background(i)))
            return i;
    return -1;
}

static int32 touched_pixels(void)
{
    struct rectangle box;
    int32 pixels = 0;

    for (touched_next(&touched, 0, &box); box.top < box.bottom; touched_next(&touched, box.bottom, &box))
        pixels += (box.right - box.left) * (box.bottom - box.top);
    return pixels;
}

/* Draws a frame into `to`; returns the colour clocks. */
static uint32 draw(const struct frame *to, int32 number, struct touched *what)
{
    renderer.frame = to;
    clock_start(NO_LIMIT);
    scene_draw_over(&renderer, &scene, number, what);
    return clock_stop();
}

int main(void)
{
    int32 args[1] = {0};

    if (!args_read("SCENE/A", args))
        return RETURN_ERROR;
    if (!scene_load(&scene, (const char *)args[0], MEMORY_ANY) || !make(&whole) || !make(&over) || !clock_open())
        return RETURN_FAIL;
    scene_reserve(&scene);
    renderer.scratch = &scratch;
    touched_begin(&touched, over.width, over.height);
    touched_fill(&touched);
    for (int32 number = 0; number < scene.header->frames; number++) {
        int32 wrong;

        text_number((int32)draw(&whole, number, 0));
        text_add(" ");
        text_number((int32)draw(&over, number, &touched));
        wrong = first_wrong();
        text_add(" ");
        text_number(touched_pixels());
        text_add(" ");
        text_number(wrong < 0 ? -1 : wrong % whole.pitch / whole.pixel_bytes);
        text_add(" ");
        text_number(wrong < 0 ? -1 : wrong / whole.pitch);
        text_print();
    }
    return RETURN_OK;
}
