#include "scene/scene.h"

#include "mesh/draw.h"
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

/* The instances before an object, from the first that is not drawn yet; returns the next. */
static uint32 draw_meshes(const struct scene *scene, uint32 first, uint32 object,
                          const struct mesh_target *target, enum polygon_result *refused)
{
    uint32 end = first;
    enum polygon_result result;

    while (end < scene->header->instances && scene->instances[end].before <= object)
        end++;
    if (end == first)
        return end;
    result = mesh_draw(scene, first, end, target);
    if (result != POLYGON_DRAWN)
        *refused = result;
    return end;
}

enum polygon_result scene_draw(const struct scene *scene, const struct frame *frame,
                               int32 number, enum form form, struct draw_counts *counts)
{
    enum polygon_result refused = POLYGON_DRAWN;
    const struct scene_object *object = scene->objects;
    struct vertex vertices[POLYGON_VERTICES_MAX];
    uint32 drawn = 0;           /* instances */
    struct mesh_target target;

    target.frame = frame;
    target.number = number;
    target.form = form;
    target.counts = counts;
    clear(frame, scene->header->background);
    for (uint32 i = 0; i < scene->header->objects; i++, object++) {
        uint32 age = (uint32)number - object->first_frame;      /* huge before the first */
        enum polygon_result result;

        if (drawn < scene->header->instances && scene->instances[drawn].before <= i)
            drawn = draw_meshes(scene, drawn, i, &target, &refused);
        if (age >= object->poses)
            continue;
        place(vertices, &scene->vertices[object->vertex], object->vertices,
              &scene->poses[object->pose + age]);
        result = polygon_draw(frame, vertices, (int32)object->vertices,
                              &scene->drawn[object->material], form, counts);
        if (result != POLYGON_DRAWN && result != POLYGON_EMPTY)
            refused = result;
    }
    draw_meshes(scene, drawn, scene->header->objects, &target, &refused);
    return refused;
}
