/* What the examples with a screen of their own share: a page of texels, a frame, a renderer, a screen, a sine. */
#ifndef STAGE_H
#define STAGE_H

#include "tmap020.h"
#include "screen/screen.h"
#include "system/file.h"
#include "system/system.h"

enum { PAGE = 65536, TURN = 64, ONE_14 = 16384 };

/* After so many fields a program ends by itself. */
#ifndef FIELDS
#define FIELDS 500
#endif

/* -DINTUITION: on a screen among those of other programs. */
#ifdef INTUITION
#define OPEN screen_open_intuition
#else
#define OPEN screen_open
#endif

static uint8 stage_room[2 * PAGE];      /* a map lies at a multiple of 65,536 */
static uint8 stage_palette[4 * 256];    /* 0, red, green, blue */
static struct map stage_map;            /* what is not set is 0 */
static struct material stage_material;
static struct frame stage_frame;
static struct scratch stage_scratch;
static struct renderer stage_renderer;
static struct screen stage_screen;
static int32 stage_refused;             /* 1: the screen has not shown the last frame */

/* Sine of an angle, TURN a turn, in 2.14. */
static int32 sine(int32 angle)
{
    static const int16 quarter[TURN / 4 + 1] = {
        0, 1606, 3196, 4756, 6270, 7723, 9102, 10394, 11585, 12665, 13623, 14449, 15137, 15679, 16069, 16305, 16384
    };
    const int32 part = angle & (TURN / 4 - 1), rest = angle & TURN / 4 ? TURN / 4 - part : part;

    return angle & TURN / 2 ? -quarter[rest] : quarter[rest];
}

/* Opens a screen for frames of width x height pixels of the size given, 1 or 2. The map is an XOR pattern. On failure
   prints a line and returns 0. */
static int32 stage_open(int32 width, int32 height, int32 size)
{
    static struct screen_form form;
    uint8 *texels = stage_room + (PAGE - 1 - ((uint32)stage_room - 1) % PAGE);

    for (int32 i = 0; i < PAGE; i++)
        texels[i] = (uint8)((i >> 8) ^ i);
    for (int32 i = 1; i < 256; i++) {
        stage_palette[4 * i + 1] = (uint8)i;
        stage_palette[4 * i + 2] = (uint8)(255 - i);
        stage_palette[4 * i + 3] = (uint8)(i / 2);
    }
    stage_map.texels = texels;
    stage_map.width = stage_map.height = 256;
    stage_map.scale = 1 << 16;
    stage_map.layout = MAP_PAGE;
    stage_map.texel_bytes = 1;
    stage_material.mapper = MAPPER_AFFINE;
    stage_material.edges = EDGES_EXACT;
    stage_material.gradients = GRADIENTS_PLANE;
    stage_material.start = START_SUBTEXEL;
    stage_material.map = &stage_map;
    /* At a multiple of 8, as the conversion to planes needs it: a static array is at one of 4. */
    if (!mem_alloc(&stage_frame.pixels, width * height, MEMORY_ANY))
        return 0;
    stage_frame.width = stage_frame.pitch = width;
    stage_frame.height = height;
    stage_frame.pixel_bytes = 1;
    stage_renderer.frame = &stage_frame;
    stage_renderer.scratch = &stage_scratch;
    form.width = width;
    form.height = height;
    form.pixel_width = form.pixel_height = size;
    form.format = PIXEL_CHUNKY;
    if (!OPEN(&stage_screen, &form))
        return 0;
    screen_palette(&stage_screen, stage_palette);
    return 1;
}

/* The key that was pressed, or NO_KEY. */
static uint32 stage_key(void)
{
    return screen_key(&stage_screen);
}

/* Shows the frame. Returns the number of the next one's field, or -1 if it is time to end. */
static int32 stage_show(uint32 key)
{
    const int32 now = (int32)screen_fields(&stage_screen);

    stage_refused = !screen_show(&stage_screen, &stage_frame, 0);
    return stage_refused || key == KEY_ESCAPE || now >= FIELDS ? -1 : now;
}

/* Gives the screen back and saves the frame; returns main's result. */
static int32 stage_close(const char *name)
{
    screen_close(&stage_screen);
    if (stage_refused) {
        print("the screen refuses the frame: another size, or pixels or pitch are not multiples of 8\n");
        return 20;
    }
    return file_save(name, stage_frame.pixels, (uint32)(stage_frame.pitch * stage_frame.height)) ? 0 : 10;
}

#endif
