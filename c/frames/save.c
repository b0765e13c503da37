#include "frames/frames.h"

#include "system/file.h"

static void frame_name(char *name, int32 number)
{
    const char *pattern = "frame_000.chunky";

    while ((*name++ = *pattern++) != 0)
        ;
    for (name -= 8; number; number /= 10)
        *--name = (char)('0' + number % 10);
}

int32 scene_save(const struct frame *frame, int32 number)
{
    char name[20];

    frame_name(name, number);
    return file_save(name, frame->pixels, (uint32)(frame->pitch * frame->height));
}
