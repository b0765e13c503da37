/* coarse - draws a scene's frames by pixels twice as large, and compares them with those of the same scene compiled so.

   coarse SCENE OTHER
   Prints a line for each frame: the first byte of the coarse one that is not the other scene's, and the first of the
   scene's own that is not the same after the coarse one; -1: none. Without coarse frames it prints "none". */
#include "frames/frames.h"
#include "polygon/scratch.h"
#include "scene/coarse.h"
#include "scene/load.h"
#include "system/arguments.h"
#include "system/outcome.h"
#include "system/system.h"
#include "system/text.h"

enum { BEYOND = 32 };

static struct scene scene, other;
static struct scratch scratch;
static struct renderer renderer;
static struct frame before, after, coarse, expected;

static void set_size(struct frame *frame, const struct scene *from)
{
    frame->width = from->header->width;
    frame->height = from->header->height;
    frame->pixel_bytes = scene_pixel_bytes(from->header->format);
    frame->pitch = frame->width * frame->pixel_bytes;
}

static int32 make(struct frame *frame)
{
    set_size(frame, &scene);
    return mem_alloc(&frame->pixels, frame->pitch * frame->height + BEYOND, MEMORY_ANY);
}

static int32 first_other(const struct frame *one, const struct frame *two)
{
    if (one->width != two->width || one->height != two->height)
        return 0;
    for (int32 i = 0; i < one->pitch * one->height; i++)
        if (one->pixels[i] != two->pixels[i])
            return i;
    return -1;
}

static void draw(const struct frame *to, struct scene *from, int32 number)
{
    renderer.frame = to;
    scene_draw(&renderer, from, number);
}

static void compare(int32 number)
{
    draw(&before, &scene, number);
    scene_set_coarse(&scene, 1);
    set_size(&coarse, &scene);
    draw(&coarse, &scene, number);
    scene_set_coarse(&scene, 0);
    draw(&after, &scene, number);
    set_size(&expected, &other);
    draw(&expected, &other, number);
    text_number(first_other(&coarse, &expected));
    text_add(" ");
    text_number(first_other(&after, &before));
    text_print();
}

int main(void)
{
    int32 args[2] = {0};

    if (!args_read("SCENE/A,OTHER/A", args))
        return RETURN_ERROR;
    if (!scene_load(&scene, (const char *)args[0], MEMORY_ANY) || !scene_load(&other, (const char *)args[1], MEMORY_ANY)
        || !make(&before) || !make(&after) || !make(&coarse) || !make(&expected))
        return RETURN_FAIL;
    renderer.scratch = &scratch;
    if (!scene_has_coarse(&scene)) {
        text_add("none");
        text_print();
    } else
        for (int32 number = 0; number < scene.header->frames; number++)
            compare(number);
    return RETURN_OK;
}
