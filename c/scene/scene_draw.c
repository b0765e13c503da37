#include "scene/scene.h"

#include "polygon/plane.h"
#include "span/scanline.h"

static void clear_16(const struct frame *frame, uint32 colour)
{
    uint32 both = colour << 16 | colour;

    for (int32 y = 0; y < frame->height; y++) {
        uint32 *to = (uint32 *)(frame->pixels + y * frame->pitch);

        for (int32 pairs = frame->width >> 1; pairs > 0; pairs--)
            *to++ = both;
    }
}

/* The background is a span of the whole width on every line. */
static void clear(const struct frame *frame, uint32 colour)
{
    static struct scanline lines[SCENE_SIDE_MAX];
    struct span_plan plan;

    for (int32 i = 0; i < frame->height; i++) {
        lines[i].left = EDGE_BIAS;
        lines[i].count = (int16)frame->width;
    }
    plan.lines = lines;
    plan.count = frame->height;
    plan.row = frame->pixels - EDGE_BIAS;
    plan.pitch = frame->pitch;
    plan.colour = colour;
    span_fill(&plan);
}

/* Whether a pose only moves. */
static int32 is_upright(const struct scene_pose *pose)
{
    return pose->xx == 65536 && pose->yy == 65536 && !pose->xy && !pose->yx;
}

static void place(struct vertex *to, const struct scene_vertex *from, uint32 count,
                  const struct scene_pose *pose)
{
    int32 upright = is_upright(pose);

    for (; count; count--, from++, to++) {
        to->x = from->x + pose->x0;
        to->y = from->y + pose->y0;
        if (!upright) {
            to->x = mul_fix(pose->xx, from->x) + mul_fix(pose->xy, from->y) + pose->x0;
            to->y = mul_fix(pose->yx, from->x) + mul_fix(pose->yy, from->y) + pose->y0;
        }
        to->s = from->s;
        to->t = from->t;
        to->shade = from->shade;
    }
}

void scene_draw(const struct scene *scene, const struct frame *frame, int32 number,
                enum form form, struct draw_counts *counts)
{
    const struct scene_object *object = scene->objects;
    struct vertex vertices[POLYGON_VERTICES_MAX];

    if (frame->pixel_bytes == 2)
        clear_16(frame, scene->header->background);
    else
        clear(frame, scene->header->background);
    for (uint32 i = 0; i < scene->header->objects; i++, object++) {
        uint32 age = (uint32)number - object->first_frame;

        if ((uint32)number < object->first_frame || age >= object->poses)
            continue;
        place(vertices, &scene->vertices[object->vertex], object->vertices,
              &scene->poses[object->pose + age]);
        polygon_draw(frame, vertices, (int32)object->vertices,
                     &scene->drawn[object->material], form, counts);
    }
}
