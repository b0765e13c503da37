/* Draws a turning box by triangles_draw: eight vertices, twelve triangles, those at the back left
   out. Saves box_0.chunky to box_3.chunky, 160x128 pixels of a byte each. */
#include "tmap020.h"

enum { WIDTH = 160, HEIGHT = 128, FRAMES = 4, PAGE = 65536, CORNERS = 8, TRIANGLES = 12 };

int32 save(const char *name, const void *data, int32 bytes);    /* start.s */

/* A page of 256x256 texels lies at a multiple of 65,536. */
static uint8 room[2 * PAGE];
static uint8 pixels[WIDTH * HEIGHT];

/* 64 * cosine and sine of 9, 27, 45 and 63 degrees. */
static const int32 cosines[FRAMES] = { 63, 57, 45, 29 };
static const int32 sines[FRAMES] = { 10, 29, 45, 57 };

/* Corner k is at x = -1 or 1 by bit 0 of k, y by bit 1, z by bit 2. Clockwise from outside. */
static const uint16 indices[3 * TRIANGLES] = {
    0, 1, 3, 0, 3, 2, 5, 4, 6, 5, 6, 7, 4, 0, 2, 4, 2, 6,
    1, 5, 7, 1, 7, 3, 4, 5, 1, 4, 1, 0, 2, 3, 7, 2, 7, 6
};

/* Turns corner k about the upright axis, then towards the viewer by 27 degrees. No perspective. */
static void set_corner(struct vertex *corner, int32 k, int32 number)
{
    const int32 x = k & 1 ? 40 : -40, y = k & 2 ? 40 : -40, z = k & 4 ? 40 : -40;
    const int32 right = cosines[number] * x - sines[number] * z;
    const int32 away = sines[number] * x + cosines[number] * z;

    corner->x = (WIDTH / 2 << 16) + right * 1024;
    corner->y = (HEIGHT / 2 << 16) + (cosines[1] * 64 * y - sines[1] * away) * 16;
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
    static char name[] = "box_0.chunky";
    uint8 *texels = room + (PAGE - 1 - ((uint32)room - 1) % PAGE);

    for (int32 i = 0; i < 256 * 256; i++)
        texels[i] = (uint8)((i >> 8) ^ i);
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
    frame.pixels = pixels;
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
    for (int32 number = 0; number < FRAMES; number++) {
        for (int32 i = 0; i < WIDTH * HEIGHT; i++)
            pixels[i] = 0;
        for (int32 k = 0; k < CORNERS; k++)
            set_corner(&vertices[k], k, number);
        if (number == FRAMES - 1)
            vertices[0].x -= 128 << 16;         /* beyond the frame: drawn by polygon_draw */
        name[4] = (char)('0' + number);
        if (triangles_draw(&renderer, &list, &material) != POLYGON_DRAWN
            || !save(name, pixels, WIDTH * HEIGHT))
            return 10;
    }
    return 0;
}
