/* Turns a textured cube on a screen of its own until Escape is pressed, or for TURNS turns; its angle follows the
   clock, 50 fields a second. Then it saves its last frame as cube.chunky, 160x128 pixels of a byte each. Linked with
   screen_start.o and the library of screens, which give everything back however the program ends. */
#include "tmap020.h"
#include "screen/screen.h"
#include "system/file.h"
#include "system/system.h"

enum { WIDTH = 160, HEIGHT = 128, PAGE = 65536, CORNERS = 8, TRIANGLES = 12, TURN = 64 };
#ifndef TURNS
#define TURNS 5
#endif
/* -DINTUITION: on a screen among those of other programs. */
#ifdef INTUITION
#define OPEN screen_open_intuition
#else
#define OPEN screen_open
#endif

static uint8 room[2 * PAGE];            /* a map lies at a multiple of 65,536 */
static uint8 palette[4 * 256];          /* 0, red, green, blue */

/* 64 * sine of a quarter turn's sixteenths. */
static const int32 sines[TURN / 4 + 1] = { 0, 6, 12, 19, 24, 30, 36, 41, 45, 49, 53, 56, 59, 61, 63, 64, 64 };

/* Corner k is at x = -1 or 1 by bit 0 of k, y by bit 1, z by bit 2. Clockwise from outside. */
static const uint16 indices[3 * TRIANGLES] = {
    0, 1, 3, 0, 3, 2, 5, 4, 6, 5, 6, 7, 4, 0, 2, 4, 2, 6,
    1, 5, 7, 1, 7, 3, 4, 5, 1, 4, 1, 0, 2, 3, 7, 2, 7, 6
};

/* Returns 64 * sine of an angle, 64 a turn. */
static int32 sine(int32 angle)
{
    const int32 part = angle & (TURN / 4 - 1);

    switch (angle / (TURN / 4) & 3) {
    case 0:
        return sines[part];
    case 1:
        return sines[TURN / 4 - part];
    case 2:
        return -sines[part];
    default:
        return -sines[TURN / 4 - part];
    }
}

/* Turns corner k about the upright axis, then towards the viewer by 27 degrees. No perspective. */
static void set_corner(struct vertex *corner, int32 k, int32 cosine, int32 of_angle)
{
    const int32 x = k & 1 ? 40 : -40, y = k & 2 ? 40 : -40, z = k & 4 ? 40 : -40;
    const int32 right = cosine * x - of_angle * z;
    const int32 away = of_angle * x + cosine * z;

    corner->x = (WIDTH / 2 << 16) + right * 1024;
    corner->y = (HEIGHT / 2 << 16) + (57 * 64 * y - 29 * away) * 16;
    corner->s = k & 1 ? 255 << 16 : 0;
    corner->t = (k & 2 ? 200 << 16 : 40 << 16) + (k & 4 ? 50 << 16 : 0);
}

int main(void)
{
    static struct map map;              /* what is not set is 0 */
    static struct material material;
    static struct frame frame;
    static struct scratch scratch;
    static struct renderer renderer;
    static struct triangle_tables tables;
    static struct triangle_list list;
    static struct vertex vertices[CORNERS];
    static struct snapped_vertex snapped[CORNERS];
    static struct screen screen;
    static struct screen_form form;
    uint8 *texels = room + (PAGE - 1 - ((uint32)room - 1) % PAGE);
    uint32 *pixels;                     /* at a multiple of 8, for the conversion to planes */
    int32 angle = 0;

    if (!mem_alloc(&pixels, WIDTH * HEIGHT, MEMORY_ANY))
        return 20;
    for (int32 i = 0; i < 256 * 256; i++)
        texels[i] = (uint8)((i >> 8) ^ i);
    for (int32 i = 0; i < 256; i++) {
        palette[4 * i + 1] = (uint8)i;
        palette[4 * i + 2] = (uint8)(i ? 255 - i : 0);
        palette[4 * i + 3] = (uint8)(i / 2);
    }
    map.texels = texels;
    map.width = map.height = 256;
    map.scale = 1 << 16;
    map.layout = MAP_PAGE;
    map.texel_bytes = 1;
    material.mapper = MAPPER_AFFINE;
    material.edges = EDGES_SNAPPED;
    material.gradients = GRADIENTS_PLANE;
    material.start = START_SUBTEXEL;
    material.map = &map;
    frame.pixels = (uint8 *)pixels;
    frame.width = frame.pitch = WIDTH;
    frame.height = HEIGHT;
    frame.pixel_bytes = 1;
    renderer.frame = &frame;
    renderer.scratch = &scratch;
    triangle_tables_make(&tables);
    renderer.triangles = &tables;
    list.vertices = vertices;
    list.vertex_count = CORNERS;
    list.indices = indices;
    list.count = TRIANGLES;
    list.cull = 1;
    list.room = snapped;

    form.width = WIDTH;
    form.height = HEIGHT;
    form.pixel_width = form.pixel_height = 2;
    form.format = PIXEL_CHUNKY;
    if (!OPEN(&screen, &form))
        return 20;                      /* it has said why */
    screen_palette(&screen, palette);
    while (angle < TURNS * TURN && screen_key(&screen) != KEY_ESCAPE) {
        angle = screen_fields(&screen) / 2;
        for (int32 i = 0; i < WIDTH * HEIGHT / 4; i++)
            pixels[i] = 0;
        for (int32 k = 0; k < CORNERS; k++) {
            if (angle < TURNS * TURN)
                set_corner(&vertices[k], k, sine(angle + TURN / 4), sine(angle));
            else
                set_corner(&vertices[k], k, 57, 29);    /* the last: 27 degrees */
        }
        triangles_draw(&renderer, &list, &material);
        if (!screen_show(&screen, &frame, 0)) {
            screen_close(&screen);
            print("the screen refuses the frame\n");
            return 20;
        }
    }
    screen_close(&screen);
    return file_save("cube.chunky", pixels, WIDTH * HEIGHT) ? 0 : 10;
}
