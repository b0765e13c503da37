/* renderers - draws two scenes by turns, each by a renderer of its own.

   renderers FIRST SECOND FRAMES n
   saves frame_000.chunky on for the first scene and frame_100.chunky on for the second. Each frame is
   saved when the other scene has been drawn and both were counted. */
#include "frames/counts.h"
#include "polygon/scratch.h"
#include "scene/load.h"
#include "system/outcome.h"
#include "system/system.h"

enum { SCENES = 2, SECOND_NUMBER = 100 };

static struct drawn {
    struct scene scene;
    struct frame frame;
    struct renderer renderer;
    struct scratch scratch;
    struct scene_counts counts;
} drawn[SCENES];

static int32 open(struct drawn *d, const char *name)
{
    struct frame *frame = &d->frame;

    if (!scene_load(&d->scene, name, MEMORY_ANY)
        || !counts_make(&d->counts, d->scene.header->materials))
        return 0;
    frame->width = d->scene.header->width;
    frame->height = d->scene.header->height;
    frame->pixel_bytes = scene_pixel_bytes(d->scene.header->format);
    frame->pitch = frame->width * frame->pixel_bytes;
    d->renderer.frame = frame;
    d->renderer.scratch = &d->scratch;
    return mem_alloc(&frame->pixels, frame->pitch * frame->height, MEMORY_ANY);
}

int main(void)
{
    enum { FIRST, SECOND, FRAMES, ITEMS };
    int32 args[ITEMS] = {0}, frames;

    if (!args_read("FIRST/A,SECOND/A,FRAMES/A/N", args))
        return RETURN_ERROR;
    frames = *(const int32 *)args[FRAMES];
    for (int32 i = 0; i < SCENES; i++)
        if (!open(&drawn[i], (const char *)args[FIRST + i]))
            return RETURN_FAIL;
    mem_reserve();
    for (int32 number = 0; number < frames; number++) {
        for (int32 i = 0; i < SCENES; i++)
            scene_draw(&drawn[i].renderer, &drawn[i].scene, number);
        for (int32 i = 0; i < SCENES; i++)
            counts_frame(&drawn[i].counts, &drawn[i].renderer, &drawn[i].scene, number);
        for (int32 i = 0; i < SCENES; i++)
            if (!scene_save(&drawn[i].frame, number + i * SECOND_NUMBER))
                return RETURN_ERROR;
    }
    return RETURN_OK;
}
