#include "scene/scene.h"

#include "polygon/math.h"
#include "span/scanline.h"

/* The background is a span of the whole width on every line. */
static void clear(const struct frame *frame, uint32 colour)
{
    static struct scanline lines[SCENE_SIDE_MAX];
    struct span_plan plan;

    for (int32 i = 0; i < frame->height; i++) {
        lines[i].left = EDGE_BIAS;
        lines[i].last = (int16)(EDGE_BIAS + frame->width - 1);
    }
    plan.lines = lines;
    plan.count = frame->height;
    plan.row = frame->pixels - EDGE_BIAS * frame->pixel_bytes;
    plan.pitch = frame->pitch;
    plan.colour = colour;
    if (frame->pixel_bytes == 2)
        span_fill_16(&plan);
    else
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
        to->w = from->w;
    }
}

enum polygon_result scene_draw(const struct scene *scene, const struct frame *frame,
                               int32 number, enum form form, struct draw_counts *counts)
{
    enum polygon_result refused = POLYGON_DRAWN;
    const struct scene_object *object = scene->objects;
    struct vertex vertices[POLYGON_VERTICES_MAX];

    clear(frame, scene->header->background);
    for (uint32 i = 0; i < scene->header->objects; i++, object++) {
        uint32 age = (uint32)number - object->first_frame;      /* huge before the first */
        enum polygon_result result;

        if (age >= object->poses)
            continue;
        place(vertices, &scene->vertices[object->vertex], object->vertices,
              &scene->poses[object->pose + age]);
        result = polygon_draw(frame, vertices, (int32)object->vertices,
                              &scene->drawn[object->material], form, counts);
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
    }
    return refused;
}
