/* Shows a model, 320x200 pixels, until Escape is pressed: cursor left and right turn it faster or back, space stops
   it. Then it saves a frame at the angle LAST as viewer.chunky. The model's tables, model.h, are made by
       scripts/tmap mesh MODEL.obj --triangles -o model.h
   Its picture is an environment: s and t come from normals. */
#include "stage.h"
#include "model.h"

enum { WIDTH = 320, HEIGHT = 200, BUCKETS = 64, FOCUS = 150, AWAY = 5 << 8, NEAREST = 2 << 8, LAST = 5,
       POINTS = sizeof model_points / sizeof *model_points, NORMALS = sizeof model_normals / sizeof *model_normals,
       FACES = sizeof model_faces / sizeof *model_faces };

static struct vertex corners[3 * FACES], placed[POINTS], looks[NORMALS];
static struct snapped_vertex snapped[3 * FACES];
static uint16 indices[3 * FACES];
static int16 next[FACES], bucket[BUCKETS];
static int32 depths[POINTS];            /* 1/256 */
static struct triangle_list list;
static struct triangle_tables tables;

/* Turns points and normals about the upright axis. */
static void turn(int32 c, int32 s)
{
    for (int32 k = 0; k < POINTS; k++) {
        const int32 x = model_points[k].x >> 8, y = model_points[k].y >> 8, z = model_points[k].z >> 8;
        const int32 depth = ((s * x + c * z) >> 14) + AWAY;

        depths[k] = depth;
        placed[k].x = (WIDTH / 2 << 16) + ((c * x - s * z) >> 14) * FOCUS * 256 / depth * 256;
        placed[k].y = (HEIGHT / 2 << 16) - y * FOCUS * 256 / depth * 256;
    }
    for (int32 k = 0; k < NORMALS; k++) {
        const struct scene_normal *normal = &model_normals[k];

        looks[k].s = (128 << 16) + ((c * normal->x - s * normal->z) >> 14) * 500;      /* 127 texels at most */
        looks[k].t = (128 << 16) - normal->y * 500;
    }
}

/* Makes the list of triangles, the farthest first. */
static void sort(void)
{
    int32 at = 0;

    for (int32 b = 0; b < BUCKETS; b++)
        bucket[b] = -1;
    for (int32 f = 0; f < FACES; f++) {
        int32 sum = 0, b;

        for (int32 k = 3 * f; k < 3 * f + 3; k++) {
            const struct scene_corner *corner = &model_corners[k];

            corners[k].x = placed[corner->point].x;
            corners[k].y = placed[corner->point].y;
            corners[k].s = looks[corner->normal].s;
            corners[k].t = looks[corner->normal].t;
            sum += depths[corner->point];
        }
        b = (sum / 3 - NEAREST) >> 4;
        b = b < 0 ? 0 : b >= BUCKETS ? BUCKETS - 1 : b;
        next[f] = bucket[b];
        bucket[b] = (int16)f;
    }
    for (int32 b = BUCKETS - 1; b >= 0; b--)
        for (int32 f = bucket[b]; f >= 0; f = next[f])
            for (int32 k = 0; k < 3; k++)
                indices[at++] = (uint16)(3 * f + k);
}

static void draw(int32 angle)
{
    uint32 *const pixels = (uint32 *)stage_frame.pixels;

    for (int32 i = 0; i < WIDTH * HEIGHT / 4; i++)
        pixels[i] = 0;
    turn(sine(angle + TURN / 4), sine(angle));
    sort();
    triangles_draw(&stage_renderer, &list, &stage_material);
}

int main(void)
{
    int32 field = 0, angle = 0, speed = 1;

    if (!stage_open(WIDTH, HEIGHT, 1))
        return 20;
    triangle_tables_make(&tables);
    stage_renderer.triangles = &tables;
    stage_material.edges = EDGES_SNAPPED;
    list.vertices = corners;
    list.vertex_count = 3 * FACES;
    list.indices = indices;
    list.count = FACES;
    list.cull = 1;
    list.room = snapped;
    while (field >= 0) {
        const uint32 key = stage_key();

        speed = key == KEY_SPACE ? 0 : speed + (key == KEY_RIGHT) - (key == KEY_LEFT);
        angle += speed;
        draw(angle);
        field = stage_show(key);
    }
    draw(LAST);
    return stage_close("viewer.chunky");
}
