/* upside - draws exact triangles down a frame and up another, whose pitch is negative, and prints how many
   pixels are drawn and how many differ. */
#include "drawing/material.h"
#include "polygon/polygon.h"
#include "polygon/scratch.h"
#include "system/text.h"

enum { WIDTH = 64, HEIGHT = 48, PAGE = 65536 };

static uint8 room[2 * PAGE], down[WIDTH * HEIGHT], up[WIDTH * HEIGHT];
static struct scratch scratch;
static struct map map;
static struct material material;
static const struct vertex corners[3] = {
    {3 << 16, 2 << 16, 5 << 16, 7 << 16, 0, 0},
    {(60 << 16) + 5000, 20 << 16, 70 << 16, 9 << 16, 0, 0},
    {20 << 16, (45 << 16) + 999, 30 << 16, 60 << 16, 0, 0}
};

int main(void)
{
    struct frame frame = {down, WIDTH, HEIGHT, WIDTH, 1};
    struct renderer renderer = {&frame, FORM_ADDX, 0, 0, 0, &scratch, 0, 0, 0};
    struct polygon polygons[2];
    uint8 *texels = room + (PAGE - 1 - ((uint32)room - 1) % PAGE);
    int32 drawn = 0, wrong = 0;

    for (int32 i = 0; i < PAGE; i++)
        texels[i] = (uint8)((i >> 8) ^ i) | 1;
    map.texels = texels;
    map.width = map.height = 256;
    map.scale = 65536;
    map.layout = MAP_PAGE;
    map.texel_bytes = 1;
    material.mapper = MAPPER_AFFINE;
    material.edges = EDGES_EXACT;
    material.gradients = GRADIENTS_PLANE;
    material.start = START_SUBTEXEL;
    material.map = &map;
    for (int32 i = 0; i < 2; i++)
        polygon_set(&polygons[i], corners, 3, PLANAR_ALL);
    polygons_draw(&renderer, polygons, 2, &material);
    frame.pixels = up + (HEIGHT - 1) * WIDTH;
    frame.pitch = -WIDTH;
    polygons_draw(&renderer, polygons, 2, &material);
    for (int32 y = 0; y < HEIGHT; y++)
        for (int32 x = 0; x < WIDTH; x++) {
            const uint8 pixel = down[y * WIDTH + x];

            drawn += pixel != 0;
            wrong += pixel != up[(HEIGHT - 1 - y) * WIDTH + x];
        }
    text_number(drawn);
    text_add(" drawn, wrong ");
    text_number(wrong);
    text_print();
    return 0;
}
