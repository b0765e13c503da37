/* scene - draws the frames of the one scene it holds into chunky dumps and times them.

   No arguments. It writes frame_000.chunky and so on into the current directory, as render
   does, and prints a line a frame: colour clocks. tools/tmap/product/scene_program.py links it. */
#include "frames/frames.h"
#include "polygon/scratch.h"
#include "scene/load.h"
#include "system/system.h"
#include "system/text.h"

/* A scene file without a palette, checked by the tools. */
extern const uint8 scene_data[];

static struct scratch scratch;

static int32 fail(const char *why)
{
    print(why);
    return RETURN_FAIL;
}

int main(void)
{
    struct scene scene;
    struct frame frame;
    struct renderer renderer = {&frame, FORM_ADDX, 0, 0, 0, &scratch, 0, 0, 0};

    scene_place(&scene, scene_data);
    scene_copy_maps(&scene, MEMORY_ANY);        /* mem_need ends the program if memory is short */
    scene_make(&scene, MEMORY_ANY);
    frame.width = scene.header->width;
    frame.height = scene.header->height;
    frame.pixel_bytes = scene_pixel_bytes(scene.header->format);
    frame.pitch = frame.width * frame.pixel_bytes;
    mem_need(&frame.pixels, frame.pitch * frame.height, MEMORY_ANY);
    scene_reserve(&scene);
    if (!clock_open())
        return fail("another program uses CIA-B's timers\n");
    for (int32 number = 0; number < scene.header->frames; number++) {
        uint32 ticks;

        if (number && break_asked())
            return RETURN_WARN;
        scene_time(&renderer, &scene, number, &ticks);
        if (!scene_save(&frame, number))
            return RETURN_ERROR;
        text_number((int32)ticks);
        text_print();
    }
    return RETURN_OK;
}
