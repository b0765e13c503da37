/* Draws a textured square, turned further from frame to frame, into a chunky buffer, and saves
   it: frame_0.chunky to frame_3.chunky, 160x128 pixels of a byte each. */
#include "tmap020.h"

enum { WIDTH = 160, HEIGHT = 128, FRAMES = 4, REACH = 60, PAGE = 65536 };

int32 save(const char *name, const void *data, int32 bytes);    /* start.s */

/* A page of 256x256 texels lies at a multiple of 65,536. */
static uint8 room[2 * PAGE];
static uint8 pixels[WIDTH * HEIGHT];

/* 64 * cosine and sine of 9, 27, 45 and 63 degrees. */
static const int32 cosines[FRAMES] = { 63, 57, 45, 29 };
static const int32 sines[FRAMES] = { 10, 29, 45, 57 };

static void set_corner(struct vertex *corner, int32 number, int32 right, int32 down)
{
    corner->x = (WIDTH / 2 << 16) + (cosines[number] * right - sines[number] * down) * 1024;
    corner->y = (HEIGHT / 2 << 16) + (sines[number] * right + cosines[number] * down) * 1024;
    corner->s = right < 0 ? 0 : 255 << 16;
    corner->t = down < 0 ? 0 : 255 << 16;
}

int main(void)
{
    static struct map map;              /* what is not set is 0 */
    static struct material material;
    static struct frame frame;
    static struct scratch scratch;
    static struct renderer renderer;    /* FORM_ADDX, all rules, no counts */
    static struct polygon polygon;
    static struct vertex square[4];
    static char name[] = "frame_0.chunky";
    uint8 *texels = room + (PAGE - 1 - ((uint32)room - 1) % PAGE);

    for (int32 i = 0; i < 256 * 256; i++)
        texels[i] = (uint8)((i >> 8) ^ i);
    map.texels = texels;
    map.width = map.height = 256;
    map.scale = 1 << 16;
    map.layout = MAP_PAGE;
    map.texel_bytes = 1;
    material.mapper = MAPPER_AFFINE;
    material.edges = EDGES_EXACT;
    material.gradients = GRADIENTS_PLANE;
    material.start = START_SUBTEXEL;
    material.map = &map;
    frame.pixels = pixels;
    frame.width = frame.pitch = WIDTH;
    frame.height = HEIGHT;
    frame.pixel_bytes = 1;
    renderer.frame = &frame;
    renderer.scratch = &scratch;
    polygon.vertices = square;
    polygon.count = 4;
    for (int32 number = 0; number < FRAMES; number++) {
        for (int32 i = 0; i < WIDTH * HEIGHT; i++)
            pixels[i] = 0;
        for (int32 k = 0; k < 4; k++)   /* clockwise from the left above */
            set_corner(&square[k], number, k == 1 || k == 2 ? REACH : -REACH,
                       k >= 2 ? REACH : -REACH);
        name[6] = (char)('0' + number);
        if (polygon_draw(&renderer, &polygon, &material) != POLYGON_DRAWN
            || !save(name, pixels, WIDTH * HEIGHT))
            return 10;
    }
    return 0;
}
